// SPDX-License-Identifier: BSD-3-Clause
#ifndef DurableFiles_h
#define DurableFiles_h

#include <filesystem>
#include <string_view>

/// Writes a new file and waits until the disk has it. Each step is checked, so that a full disk is
/// noticed here.
/// @throw std::system_error  it can't be written, or exists
void writeFile(const std::filesystem::path& file, std::string_view content);

/// Writes a file in the place of an older one, if there is one. That stays as it is if this fails.
/// @throw std::system_error  it can't be written
void replaceFile(const std::filesystem::path& file, std::string_view content);

/// Waits until the disk has a file's content or a folder's list of files.
/// @throw std::system_error  the disk reports an error
void sync(const std::filesystem::path& fileOrFolder);

/// A lock of a folder against other processes. It ends with the process, however that ends. On a file
/// system that can't lock folders nobody holds one.
class FolderLock
{
public:
  enum Patience
  {
    Wait, ///< until it is free
    Try   ///< do not wait
  };
  FolderLock(const std::filesystem::path& folder, Patience patience);
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  ~FolderLock();

  bool isHeld() const { return this->Descriptor >= 0; }

private:
  int Descriptor = -1;
};

#endif
