// SPDX-License-Identifier: BSD-3-Clause
#ifndef PagePictures_h
#define PagePictures_h

#include <filesystem>
#include <string>

struct ThicknessMap;

/// The pictures of report.html, each the content of a .png file; or why there are none.
struct PagePictures
{
  std::string surface, axis, parts;
  std::string missing;
};

/// Writes what drawPagePictures() needs beside thickness.vtp and pruned.vtp, and gives its order, as a text that can be
/// sent to another process.
/// @param results  folder with these two
/// @param scratch  folder for what it needs, and for the pictures
/// @throw std::system_error  it can't be written to
std::string pagePictureOrder(const std::filesystem::path& results,
  const std::filesystem::path& scratch, const ThicknessMap& map);

/// Draws surface and axis coloured by thickness, and the parts, all seen from the same place.
/// @throw InputError  a result can't be read, or a picture can't be written
void drawPagePictures(const std::string& order);

/// What was drawn.
/// @throw InputError  a picture can't be read
PagePictures drawnPagePictures(const std::filesystem::path& scratch);

#endif
