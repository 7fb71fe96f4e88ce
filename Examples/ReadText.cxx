// SPDX-License-Identifier: BSD-3-Clause
#include "ReadText.h"

#include "Lines.h"
#include "Polygons.h"

#include <algorithm>
#include <cctype>

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

/// Does it name the columns x y z, as in: x y z, "X","Y","Z", //X Y Z?
bool namesColumns(const Lines& lines)
{
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, lines.words().size()); ++i)
  {
    for (const char c : lines.words()[i])
    {
      const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      names += c == '"' || c == '\'' || c == '/' ? std::string() : std::string(1, small);
    }
  }
  return names == "xyz";
}
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
  const bool isNamed = count < 0 && more && namesColumns(lines);
  if (isNamed)
  {
    more = lines.next();
  }
  for (; more; more = lines.next())
  {
    const bool isFirst = lines.number() == first; // perhaps a header
    polygons.addPoint(lines.point(
      0, isFirst ? "x y z (delete this line if it is a header over columns x y z)" : "x y z"));
    polygons.noteWords(lines.words(), 0);
  }
  if (!isNamed)
  {
    lines.refuseAmbiguousCommas();
  }
  if (count >= 0 && count != polygons.points())
  {
    throw InputError(file + ", line " + std::to_string(first) + ": announces " +
      std::to_string(count) + " points, but " + std::to_string(polygons.points()) +
      " follow; the file was cut, or the number is wrong: correct or delete it");
  }
  return polygons.take();
}
