// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pyramid_h
#define Pyramid_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

/// A pyramid in every format that is read: five points, a square and four triangles.
namespace pyramid
{
using Read = vtkSmartPointer<vtkPolyData> (*)(const std::string& file);
using Cells = std::vector<std::vector<std::int32_t>>;

struct Format
{
  const char* name;
  Read read;
  std::string content; ///< of the file; in .stl the square is two triangles
  int type;            ///< of its coordinates
};

std::vector<Format> formats();

/// A .vtp file with the points of the pyramid.
/// @param counts  attributes of the piece beside the number of points
/// @param cells   elements of the piece
std::string vtp(const std::string& counts, const std::string& cells);

/// The same with the polygons of the pyramid.
std::string vtp();

/// A .vtu file with the points of the pyramid.
std::string vtu(const Cells& cells, const std::string& types);

/// The same with the polygons of the pyramid, of several types.
std::string vtu();

/// Corners and offsets of cells, as in .vtp and .vtu files.
std::string cellArrays(const Cells& cells);

/// Writes a file, and returns its path.
std::string write(const std::string& name, const std::string& content);
}

#endif
