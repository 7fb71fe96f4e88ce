// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pictures_h
#define Pictures_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

class Canvas;

/// What stands below samples, axis, parts, pruned axis and surface in the overview.
using Captions = std::array<std::string, 5>;

/// An order for drawPictures(), as a text that can be sent to another process.
/// @param results  folder with samples.vtp, axis.vtp, parts.vtp, pruned.vtp and surface.vtp
/// @param target   folder for the pictures
std::string pictureOrder(const std::filesystem::path& results, const std::filesystem::path& target,
  const Captions& captions);

/// Draws a picture of each stage, all seen from the same place, and an overview with all five side by
/// side.
/// @throw InputError  a result can't be read, or a picture can't be written
void drawPictures(const std::string& order);

// What other drawings need, too.

/// An order of pieces: each ends with a zero, which occurs in no path and no caption.
std::string orderOf(const std::vector<std::string>& pieces);
std::vector<std::string> piecesOf(const std::string& order);

/// @throw InputError  it can't be read
vtkSmartPointer<vtkPolyData> readPolyData(const std::filesystem::path& file);

/// @throw InputError  it can't be written
void writePicture(Canvas& canvas, const std::filesystem::path& file);

#endif
