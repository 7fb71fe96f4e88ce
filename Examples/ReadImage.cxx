// SPDX-License-Identifier: BSD-3-Clause
#include "ReadImage.h"

#include "ChildProcess.h"
#include "Errors.h"
#include "ImageBytes.h"

#include <filesystem>
#include <functional>

namespace
{
constexpr double Megabyte = 1 << 20;
constexpr double Room = 500 * Megabyte; ///< for what doesn't depend on the image
constexpr double Time = 0.7;            ///< s, the same

/// The size of a file, or of all in a folder.
double sizeOf(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_directory(path, error))
  {
    const auto size = std::filesystem::file_size(path, error);
    return error ? 0 : static_cast<double>(size);
  }
  double result = 0;
  for (auto entry = std::filesystem::recursive_directory_iterator(
         path, std::filesystem::directory_options::skip_permission_denied, error);
       !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error))
  {
    std::error_code none;
    const auto size = entry->file_size(none);
    result += none ? 0 : static_cast<double>(size);
  }
  return result;
}

/// For what is in a header. Deflated data are inflated once; they grow to a thousandfold, 300 MB/s.
Limits headerLimits(double fileSize)
{
  constexpr double rate = 0.3 * Megabyte;
  return { static_cast<std::size_t>(Room + 4 * fileSize), Time + fileSize / rate };
}

/// For the voxels. The file, the image, its values as float, and both once more on their way out are in
/// memory at a time. Numbers as text are the slowest.
Limits voxelLimits(double announced)
{
  constexpr double rate = 5 * Megabyte;
  return { static_cast<std::size_t>(Room + 12 * announced), Time + announced / rate };
}

std::string readApart(
  const ImageSource& source, const std::function<std::string()>& read, const Limits& limits)
{
  ChildResult result = inChildProcess(read, limits);
  if (result.ending == Ending::Died)
  {
    throw InputError(source.file +
      ": VTK's reader crashes, or takes too much time or memory; the file is damaged: write it "
      "anew");
  }
  if (result.ending == Ending::Threw)
  {
    throw InputError(source.file + ": can't be read: " + result.text);
  }
  return std::move(result.text);
}
}

vtkSmartPointer<vtkImageData> readImage(const ImageSource& source)
{
  const std::string announced = readApart(
    source, [&] { return std::to_string(announcedBytes(source)); },
    headerLimits(sizeOf(source.file)));
  return imageOf(readApart(
    source, [&] { return bytesOf(readImageFile(source)); }, voxelLimits(std::stod(announced))));
}
