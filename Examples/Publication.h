// SPDX-License-Identifier: BSD-3-Clause
#ifndef Publication_h
#define Publication_h

#include <filesystem>
#include <set>
#include <string>

/// Makes a draft's files a folder that did not exist before.
/// @param draft  a folder on the same disk, with the files in its subfolder `new`; it is gone afterwards
/// @return false if the folder exists; then nothing has changed
/// @throw std::system_error  the folder can't be made
bool publishAsFolder(const std::filesystem::path& draft, const std::filesystem::path& folder);

/// Puts new results into a folder that may hold older ones, in one step. Whoever opens files by their
/// names finds the old results or the new ones, never some of each, even if the process is killed or
/// the power fails at any time. Other files of the folder, and the folder itself, stay the same ones.
///
/// 1. The draft gets a folder `old` with the old files (hard links, which take no space), and a symbolic
///    link `now` to it. Then the draft is moved into the results' folder, as `.SimplifyShape.switch`.
/// 2. Each name is replaced by a symbolic link to that name in `now`. All names still give the old files.
/// 3. `now` is replaced by a link to `new`. This one rename switches all names.
/// 4. Each link is replaced by its file, and `.SimplifyShape.switch` is removed.
///
/// We do not exchange the whole folder, because its other files would have to move twice, it may be a
/// mount point, and whoever works in it would be left in a folder that is gone. On a file system without
/// symbolic links, as FAT, the files are moved one by one.
///
/// The caller holds the lock of the folder.
/// @param draft  as above
/// @param names  files that go, if they are not among the new ones
/// @throw std::system_error  the folder can't be written to; then it has the old results
void publishInto(const std::filesystem::path& draft, const std::filesystem::path& folder,
  const std::set<std::string>& names);

/// Brings to its end what a killed run has begun in a folder: backwards before step 3, else forwards. Does
/// nothing if there is nothing. The caller holds the lock of the folder.
/// @throw std::system_error  the folder can't be written to
void finishSwitch(const std::filesystem::path& folder);

#endif
