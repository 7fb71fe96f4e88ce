// SPDX-License-Identifier: BSD-3-Clause
#include "DurableFiles.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace
{
[[noreturn]] void fail(const std::filesystem::path& file)
{
  throw std::system_error(errno, std::generic_category(), file.string());
}

/// A file or folder that is closed at the end.
class Opened
{
public:
  Opened(const std::filesystem::path& file, int flags)
    : Descriptor(open(file.c_str(), flags | O_CLOEXEC, 0666))
  {
    if (this->Descriptor < 0)
    {
      fail(file);
    }
  }
  ~Opened() { close(this->Descriptor); }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;

  const int Descriptor;
};

void sync(const Opened& opened, const std::filesystem::path& file)
{
  // Some file systems have nothing to wait for, and say EINVAL.
  if (fsync(opened.Descriptor) != 0 && errno != EINVAL && errno != ENOTSUP)
  {
    fail(file);
  }
}
}

void writeFile(const std::filesystem::path& file, std::string_view content)
{
  const Opened opened(file, O_WRONLY | O_CREAT | O_EXCL);
  while (!content.empty())
  {
    const ssize_t written = write(opened.Descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR)
    {
      fail(file);
    }
    content.remove_prefix(written > 0 ? written : 0);
  }
  sync(opened, file); // what close() could report is reported here
}

void replaceFile(const std::filesystem::path& file, std::string_view content)
{
  std::filesystem::path part = file;
  part += ".part";
  std::filesystem::remove(part); // of a run that was killed
  try
  {
    writeFile(part, content);
    std::filesystem::rename(part, file);
  }
  catch (const std::system_error&)
  {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
}

void sync(const std::filesystem::path& fileOrFolder)
{
  sync(Opened(fileOrFolder, O_RDONLY), fileOrFolder);
}

FolderLock::FolderLock(const std::filesystem::path& folder, Patience patience)
  : Descriptor(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
  int result = -1;
  do
  {
    result = this->Descriptor < 0
      ? -1
      : flock(this->Descriptor, LOCK_EX | (patience == Try ? LOCK_NB : 0));
  }
  while (result != 0 && errno == EINTR);
  if (result != 0 && this->Descriptor >= 0)
  {
    close(std::exchange(this->Descriptor, -1));
  }
}

FolderLock::FolderLock(FolderLock&& other) noexcept
  : Descriptor(std::exchange(other.Descriptor, -1))
{
}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept
{
  std::swap(this->Descriptor, other.Descriptor);
  return *this;
}

FolderLock::~FolderLock()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
  }
}
