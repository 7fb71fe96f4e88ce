// SPDX-License-Identifier: BSD-3-Clause
//
// A library to preload. It counts the calls by which a program changes its folders and files, and at the
// call of number MEDIAL_FAIL_AT does what MEDIAL_FAIL_BY says:
//   kill  the process dies before the call
//   full  this call and all later ones that need space on the disk fail
//   io    this call and all later ones fail
// With MEDIAL_NO_LINKS=hard the file system has no hard links, with MEDIAL_NO_LINKS=all no symbolic ones
// either.

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <dlfcn.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace
{
enum Need
{
  Space,
  NoSpace
};

/// Counts a call. True if it is to fail; then errno is set.
bool fails(Need need)
{
  static int count = 0;
  const char* at = std::getenv("MEDIAL_FAIL_AT");
  const char* by = std::getenv("MEDIAL_FAIL_BY");
  if (!at || !by || ++count < std::atoi(at))
  {
    return false;
  }
  const std::string way = by;
  if (way == "kill")
  {
    raise(SIGKILL);
  }
  errno = way == "full" ? ENOSPC : EIO;
  return way == "io" || need == Space;
}

/// True if the file system seems to lack links of this kind; then errno is set.
bool lacksLinks(const std::string& kind)
{
  const char* lacking = std::getenv("MEDIAL_NO_LINKS");
  if (!lacking || (lacking != kind && lacking != std::string("all")))
  {
    return false;
  }
  errno = EPERM;
  return true;
}

template <typename Function>
Function* original(const char* name)
{
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
}

extern "C"
{
  int rename(const char* from, const char* to)
  {
    return fails(NoSpace) ? -1 : original<int(const char*, const char*)>("rename")(from, to);
  }

  int symlink(const char* target, const char* link)
  {
    return fails(Space) || lacksLinks("symbolic")
      ? -1
      : original<int(const char*, const char*)>("symlink")(target, link);
  }

  int link(const char* from, const char* to)
  {
    return fails(Space) || lacksLinks("hard")
      ? -1
      : original<int(const char*, const char*)>("link")(from, to);
  }

  int mkdir(const char* path, mode_t mode)
  {
    return fails(Space) ? -1 : original<int(const char*, mode_t)>("mkdir")(path, mode);
  }

  char* mkdtemp(char* name)
  {
    return fails(Space) ? nullptr : original<char*(char*)>("mkdtemp")(name);
  }

  int unlinkat(int folder, const char* path, int flags)
  {
    return fails(NoSpace) ? -1
                          : original<int(int, const char*, int)>("unlinkat")(folder, path, flags);
  }

  int remove(const char* path)
  {
    return fails(NoSpace) ? -1 : original<int(const char*)>("remove")(path);
  }

  int fsync(int file)
  {
    struct stat status = {};
    const bool isFile = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
    return fails(isFile ? Space : NoSpace) ? -1 : original<int(int)>("fsync")(file);
  }

  ssize_t write(int file, const void* bytes, size_t size)
  {
    static auto* const call = original<ssize_t(int, const void*, size_t)>("write");
    return file > 2 && fails(Space) ? -1 : call(file, bytes, size);
  }
}
