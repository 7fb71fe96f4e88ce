// SPDX-License-Identifier: BSD-3-Clause
#include "Pyramid.h"

#include "ReadObj.h"
#include "ReadPly.h"
#include "ReadStl.h"
#include "ReadText.h"
#include "ReadXml.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pyramid
{
namespace
{
template <typename Value>
void append(std::string& text, Value value, bool isSwapped)
{
  std::array<char, sizeof(Value)> bytes;
  std::memcpy(bytes.data(), &value, sizeof value);
  if (isSwapped)
  {
    std::reverse(bytes.begin(), bytes.end());
  }
  text.append(bytes.data(), bytes.size());
}

const std::vector<std::array<double, 3>> Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
  { 0, 1, 0 }, { 0.5, 0.5, 1 } };
const Cells Faces = { { 3, 2, 1, 0 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };

std::string plyHeaderOf(const std::string& format, const std::string& type)
{
  return "ply\nformat " + format + " 1.0\nelement vertex 5\nproperty " + type + " x\nproperty " +
    type + " y\nproperty " + type +
    " z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n";
}

template <typename Real>
std::string binaryPly(const std::string& format, const std::string& type, bool isSwapped)
{
  std::string text = plyHeaderOf(format, type);
  for (const auto& point : Points)
  {
    for (const double value : point)
    {
      append(text, static_cast<Real>(value), isSwapped);
    }
  }
  for (const auto& face : Faces)
  {
    append(text, static_cast<std::uint8_t>(face.size()), isSwapped);
    for (const std::int32_t corner : face)
    {
      append(text, corner, isSwapped);
    }
  }
  return text;
}

/// A line for each of the points, and one for each of the faces.
std::string lines(
  const std::string& beforePoint, const std::string& beforeFace, bool hasCount, int first)
{
  std::string text;
  for (const auto& [x, y, z] : Points)
  {
    text +=
      beforePoint + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
  }
  for (const auto& face : Faces)
  {
    text += beforeFace + (hasCount ? std::to_string(face.size()) : "");
    for (const int corner : face)
    {
      text += ' ' + std::to_string(first + corner);
    }
    text += '\n';
  }
  return text;
}

/// The corners of the triangles, one after another.
std::vector<std::array<double, 3>> corners()
{
  std::vector<std::array<double, 3>> result;
  for (const auto& face : Faces)
  {
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      result.insert(result.end(), { Points[face[0]], Points[face[i - 1]], Points[face[i]] });
    }
  }
  return result;
}

std::string asciiStl()
{
  std::string text = "solid pyramid\n";
  int corner = 0;
  for (const auto& [x, y, z] : corners())
  {
    text += corner % 3 == 0 ? "facet normal 0 0 0\nouter loop\n" : "";
    text +=
      "vertex " + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + '\n';
    text += ++corner % 3 == 0 ? "endloop\nendfacet\n" : "";
  }
  return text + "endsolid pyramid\n";
}

std::string binaryStl(bool isSwapped)
{
  std::string text(80, ' ');
  const auto all = corners();
  append(text, static_cast<std::uint32_t>(all.size() / 3), isSwapped);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    text += i % 3 == 0 ? std::string(12, '\0') : "";
    for (const double value : all[i])
    {
      append(text, static_cast<float>(value), isSwapped);
    }
    text += i % 3 == 2 ? std::string(2, '\0') : "";
  }
  return text;
}

std::string dataArray(const std::string& name, const std::string& type, const std::string& values)
{
  return "<DataArray Name='" + name + "' type='" + type + "' format='ascii' NumberOfComponents='" +
    (name == "Points" ? "3" : "1") + "'>" + values + "</DataArray>\n";
}

/// A .vtp or .vtu file with the points of the pyramid.
/// @param counts  attributes of the piece beside the number of points
/// @param cells   elements of the piece
std::string xml(const std::string& kind, const std::string& counts, const std::string& cells)
{
  std::string points;
  for (const auto& [x, y, z] : Points)
  {
    points += std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(z) + ' ';
  }
  return "<?xml version='1.0'?>\n<VTKFile type='" + kind + "' version='0.1'>\n<" + kind +
    "><Piece NumberOfPoints='5' " + counts + ">\n<Points>" +
    dataArray("Points", "Float32", points) + "</Points>\n" + cells + "</Piece></" + kind +
    "></VTKFile>\n";
}
}

std::string cellArrays(const Cells& cells)
{
  std::string corners, offsets;
  std::size_t end = 0;
  for (const auto& cell : cells)
  {
    for (const std::int32_t corner : cell)
    {
      corners += std::to_string(corner) + ' ';
    }
    offsets += std::to_string(end += cell.size()) + ' ';
  }
  return dataArray("connectivity", "Int64", corners) + dataArray("offsets", "Int64", offsets);
}

std::string vtp(const std::string& counts, const std::string& cells)
{
  return xml("PolyData", counts, cells);
}

std::string vtp()
{
  return vtp("NumberOfPolys='5'", "<Polys>" + cellArrays(Faces) + "</Polys>");
}

std::string vtu(const Cells& cells, const std::string& types)
{
  return xml("UnstructuredGrid", "NumberOfCells='" + std::to_string(cells.size()) + "'",
    "<Cells>" + cellArrays(cells) + dataArray("types", "UInt8", types) + "</Cells>");
}

std::string vtu()
{
  return vtu(Faces, "9 5 7 5 5");
}

std::vector<Format> formats()
{
  const std::uint16_t one = 1;
  char first = 0;
  std::memcpy(&first, &one, 1);
  const bool isBig = first == 0; // this machine
  return {
    { "ascii.ply", readPly, plyHeaderOf("ascii", "double") + lines("", "", true, 0), VTK_DOUBLE },
    { "little.ply", readPly, binaryPly<float>("binary_little_endian", "float", isBig), VTK_FLOAT },
    { "big.ply", readPly, binaryPly<double>("binary_big_endian", "double", !isBig), VTK_DOUBLE },
    { "pyramid.obj", readObj, lines("v ", "f", false, 1), VTK_DOUBLE },
    { "pyramid.off", readOff, "OFF\n5 5 0\n" + lines("", "", true, 0), VTK_DOUBLE },
    { "ascii.stl", readStl, asciiStl(), VTK_DOUBLE },
    { "binary.stl", readStl, binaryStl(isBig), VTK_FLOAT },
    { "pyramid.vtp", readVtp, vtp(), VTK_FLOAT },
    { "pyramid.vtu", readVtu, vtu(), VTK_FLOAT },
  };
}

std::string write(const std::string& name, const std::string& content)
{
  const std::string file = (std::filesystem::path(testing::TempDir()) / name).string();
  std::ofstream(file, std::ios::binary) << content;
  return file;
}
}
