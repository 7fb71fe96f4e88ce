// SPDX-License-Identifier: BSD-3-Clause
#include "Publication.h"

#include "DurableFiles.h"

#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace
{
const fs::path SwitchName = ".SimplifyShape.switch";

/// What a name is a link to during a switch.
fs::path linkTarget(const fs::path& name)
{
  return SwitchName / "now" / name;
}

/// Names that are links into the switch.
std::vector<fs::path> linkedNames(const fs::path& folder)
{
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    const fs::path name = entry.path().filename();
    if (entry.is_symlink() && fs::read_symlink(entry.path()) == linkTarget(name))
    {
      names.push_back(name);
    }
  }
  return names;
}

/// Makes `copy` another name of a file. It is a real copy where there are no hard links to it.
void keepOld(const fs::path& file, const fs::path& copy)
{
  if (fs::is_symlink(file))
  {
    fs::create_symlink(fs::absolute(file.parent_path() / fs::read_symlink(file)), copy);
    return;
  }
  std::error_code noLink;
  fs::create_hard_link(file, copy, noLink);
  if (noLink)
  {
    fs::copy_file(file, copy);
    sync(copy);
  }
}

/// Names of these that the folder has, or the draft.
std::set<std::string> namesInUse(
  const fs::path& draft, const fs::path& folder, const std::set<std::string>& names)
{
  std::set<std::string> used;
  for (const fs::directory_entry& entry : fs::directory_iterator(draft / "new"))
  {
    used.insert(entry.path().filename().string());
  }
  for (const std::string& name : names)
  {
    if (fs::exists(fs::symlink_status(folder / name)))
    {
      used.insert(name);
    }
  }
  return used;
}

/// Gives the draft its folder `old` and the link `now`. False if the file system has no symbolic links.
bool prepare(const fs::path& draft, const fs::path& folder, const std::set<std::string>& names)
{
  std::error_code noLink;
  fs::create_symlink("old", draft / "now", noLink);
  if (noLink == std::errc::operation_not_permitted || noLink == std::errc::not_supported ||
    noLink == std::errc::function_not_supported || noLink == std::errc::operation_not_supported)
  {
    return false;
  }
  if (noLink)
  {
    throw fs::filesystem_error("", draft, noLink);
  }
  fs::create_directory(draft / "old");
  for (const std::string& name : names)
  {
    const fs::file_status status = fs::symlink_status(folder / name);
    if (fs::is_directory(status))
    {
      throw fs::filesystem_error(
        "", folder / name, std::make_error_code(std::errc::is_a_directory));
    }
    if (fs::exists(status))
    {
      keepOld(folder / name, draft / "old" / name);
    }
  }
  sync(draft / "old");
  sync(draft);
  return true;
}

void moveOneByOne(const fs::path& draft, const fs::path& folder, const std::set<std::string>& names)
{
  for (const std::string& name : names)
  {
    if (fs::exists(draft / "new" / name))
    {
      fs::rename(draft / "new" / name, folder / name);
    }
    else
    {
      fs::remove(folder / name);
    }
  }
  sync(folder);
  fs::remove_all(draft);
}

void replaceByLink(const fs::path& link, const fs::path& target, const fs::path& scratch)
{
  fs::create_symlink(target, scratch);
  fs::rename(scratch, link);
}

/// Steps 1 to 3.
void switchNames(const fs::path& draft, const fs::path& folder, const std::set<std::string>& names)
{
  const fs::path place = folder / SwitchName;
  fs::rename(draft, place);
  try
  {
    for (const std::string& name : names)
    {
      replaceByLink(folder / name, linkTarget(name), place / "link");
    }
    sync(folder);
    replaceByLink(place / "now", "new", place / "link");
  }
  catch (const std::system_error&)
  {
    finishSwitch(folder); // backwards
    throw;
  }
  sync(place);
}
}

bool publishAsFolder(const fs::path& draft, const fs::path& folder)
{
  if (fs::exists(folder))
  {
    return false;
  }
  sync(draft / "new");
  std::error_code error;
  fs::rename(draft / "new", folder, error);
  if (error && !fs::exists(folder)) // another run may have made it just now
  {
    throw fs::filesystem_error("", folder, error);
  }
  if (!error)
  {
    sync(folder.parent_path());
    fs::remove_all(draft);
  }
  return !error;
}

void publishInto(const fs::path& draft, const fs::path& folder, const std::set<std::string>& names)
{
  sync(draft / "new");
  finishSwitch(folder);
  const std::set<std::string> all = namesInUse(draft, folder, names);
  if (!prepare(draft, folder, all))
  {
    moveOneByOne(draft, folder, all);
    return;
  }
  switchNames(draft, folder, all);
  finishSwitch(folder);
}

void finishSwitch(const fs::path& folder)
{
  const fs::path place = folder / SwitchName;
  if (!fs::is_directory(fs::symlink_status(place)))
  {
    return;
  }
  std::error_code
    noLink; // a killed run was about to remove the switch; then no name is a link any more
  const fs::path current = fs::read_symlink(place / "now", noLink);
  for (const fs::path& name : linkedNames(folder))
  {
    const fs::path file = place / current / name;
    if (fs::exists(fs::symlink_status(file)))
    {
      fs::rename(file, folder / name);
    }
    else
    {
      fs::remove(folder / name);
    }
  }
  sync(folder);
  fs::remove_all(place);
}
