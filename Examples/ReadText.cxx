// SPDX-License-Identifier: BSD-3-Clause
#include "ReadText.h"

#include "Lines.h"
#include "Polygons.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

namespace
{
/// The words of an .off file's counts. They stand after the keyword or in the next line.
/// @return  how many words of the line are before them
std::size_t findCounts(Lines& lines)
{
  if (!lines.next())
  {
    throw lines.error("the file is empty");
  }
  const std::string_view keyword = lines.words()[0];
  const std::size_t size = keyword.size();
  if (size < 3 || keyword.substr(size - 3) != "OFF" ||
    keyword.find_first_not_of("STCNOF") != keyword.npos)
  {
    throw lines.error("not an .off file of points in space: it doesn't begin with OFF");
  }
  if (lines.words().size() > 1 && lines.words()[1] == "BINARY")
  {
    throw lines.error("binary .off files can't be read; convert it to .ply or to ASCII");
  }
  if (lines.words().size() > 1)
  {
    return 1;
  }
  if (!lines.next())
  {
    throw lines.error("the numbers of points, faces and edges are missing");
  }
  return 0;
}

long long count(const Lines& lines, std::size_t place)
{
  long long value = 0;
  if (place < lines.words().size() && !parseWhole(lines.words()[place], value))
  {
    throw lines.unexpected("the numbers of points, faces and edges");
  }
  return value;
}

void nextOf(Lines& lines, long long i, long long count, const char* what)
{
  if (!lines.next())
  {
    throw lines.error("the file ends after " + std::to_string(i) + " of " + std::to_string(count) +
      what + "; it was cut, or its counts are wrong");
  }
}

/// The corners of a face: their number, their indices; colours may follow.
void takeFace(const Lines& lines, Polygons& polygons, long long points)
{
  long long corners = 0;
  if (!parseWhole(lines.words()[0], corners) ||
    corners >= static_cast<long long>(lines.words().size()))
  {
    throw lines.unexpected("the number of a face's corners and their indices");
  }
  polygons.begin();
  for (long long k = 1; k <= corners; ++k)
  {
    long long index = 0;
    if (!parseWhole(lines.words()[k], index) || index >= points)
    {
      throw lines.unexpected(
        "a face with indices of points from 0 to " + std::to_string(points - 1));
    }
    polygons.add(index);
  }
  polygons.end();
}

/// The names of columns, without quotes and in small letters, as in: x y z, "X","Y","Z", //X Y Z. Empty unless
/// they begin with x y z.
std::vector<std::string> columnNames(const Lines& lines)
{
  std::vector<std::string> names;
  for (const std::string_view word : lines.words())
  {
    std::string name;
    for (const char c : word)
    {
      const bool isQuote = c == '"' || c == '\'' || c == '/';
      name += isQuote ? "" : std::string(1, std::tolower(static_cast<unsigned char>(c)));
    }
    names.push_back(name);
  }
  names.erase(std::remove(names.begin(), names.end(), ""), names.end());
  const std::vector<std::string> needed = { "x", "y", "z" };
  const bool areNamed =
    names.size() >= needed.size() && std::equal(needed.begin(), needed.end(), names.begin());
  return areNamed ? names : std::vector<std::string>();
}

/// Finds the normals among the columns of a text.
class NormalColumns
{
public:
  /// @param names  of the columns; empty where they have none
  explicit NormalColumns(const std::vector<std::string>& names)
    : AreNamed(!names.empty())
  {
    const std::vector<std::string> wanted = { "nx", "ny", "nz" };
    const auto found = std::search(names.begin(), names.end(), wanted.begin(), wanted.end());
    this->First = !this->AreNamed ? 3 : found == names.end() ? 0 : found - names.begin();
  }

  /// Takes the normal of a line, if it is one.
  void read(const Lines& lines)
  {
    const std::size_t size = lines.words().size();
    std::array<double, 3> normal = {};
    bool isNormal = this->First > 0 && (this->AreNamed ? size >= this->First + 3 : size == 6);
    for (std::size_t k = 0; isNormal && k < 3; ++k)
    {
      isNormal = parseReal(lines.words()[this->First + k], normal[k]);
    }
    // Colours don't have this length. Texts of two digits are that precise.
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    isNormal = isNormal && (this->AreNamed || std::abs(length - 1) < 0.01);
    this->IsMissing = this->IsMissing || !isNormal;
    if (!this->IsMissing)
    {
      this->Normals.push_back(normal);
    }
  }

  /// Of all lines; empty if one had none.
  std::vector<std::array<double, 3>> normals() const
  {
    return this->IsMissing ? std::vector<std::array<double, 3>>() : this->Normals;
  }

private:
  bool AreNamed;
  std::size_t First; ///< column of nx, 0 if there is none
  bool IsMissing = false;
  std::vector<std::array<double, 3>> Normals;
};
}

vtkSmartPointer<vtkPolyData> readOff(const std::string& file)
{
  const std::string content = contentOf(file);
  Lines lines(file, content, Lines::Columns);
  const std::size_t first = findCounts(lines);
  if (lines.words().size() == first)
  {
    throw lines.unexpected("the numbers of points, faces and edges");
  }
  const long long points = count(lines, first), faces = count(lines, first + 1);
  Polygons polygons(VTK_DOUBLE);
  for (long long i = 0; i < points; ++i)
  {
    nextOf(lines, i, points, " points");
    polygons.addPoint(lines.point(0, "x y z of a point"));
    polygons.noteWords(lines.words(), 0);
  }
  for (long long i = 0; i < faces; ++i)
  {
    nextOf(lines, i, faces, " faces");
    takeFace(lines, polygons, points);
  }
  lines.refuseAmbiguousCommas();
  if (lines.next())
  {
    throw lines.error("there are more lines than the " + std::to_string(points) + " points and " +
      std::to_string(faces) + " faces that the file announces; correct its counts");
  }
  return polygons.take();
}

vtkSmartPointer<vtkPolyData> readXyz(const std::string& file)
{
  const std::string content = contentOf(file);
  Lines lines(file, content, Lines::Columns);
  Polygons polygons(VTK_DOUBLE);
  bool more = lines.next();
  long long count = -1;
  const long first = lines.number();
  if (more && lines.words().size() == 1 && parseWhole(lines.words()[0], count))
  {
    more = lines.next();
  }
  const std::vector<std::string> names =
    count < 0 && more ? columnNames(lines) : std::vector<std::string>();
  NormalColumns normals(names);
  if (!names.empty())
  {
    more = lines.next();
  }
  for (; more; more = lines.next())
  {
    const bool isFirst = lines.number() == first; // perhaps a header
    polygons.addPoint(lines.point(
      0, isFirst ? "x y z (delete this line if it is a header over columns x y z)" : "x y z"));
    polygons.noteWords(lines.words(), 0);
    normals.read(lines);
  }
  if (names.empty())
  {
    lines.refuseAmbiguousCommas();
  }
  if (count >= 0 && count != polygons.points())
  {
    throw InputError(file + ", line " + std::to_string(first) + ": announces " +
      std::to_string(count) + " points, but " + std::to_string(polygons.points()) +
      " follow; the file was cut, or the number is wrong: correct or delete it");
  }
  for (const std::array<double, 3>& normal : normals.normals())
  {
    polygons.addNormal(normal);
  }
  return polygons.take();
}
