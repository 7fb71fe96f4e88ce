// SPDX-License-Identifier: BSD-3-Clause
#include "ReadStl.h"

#include "Lines.h"
#include "Polygons.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <map>
#include <string_view>
#include <vector>

namespace
{
constexpr std::size_t HeaderSize = 84; ///< 80 bytes of text, the number of triangles
constexpr std::size_t RowSize = 50;    ///< normal, three corners, two more bytes

/// Makes one point of all corners with the same coordinates.
class Corners
{
public:
  explicit Corners(int type)
    : Result(type)
  {
  }

  void begin() { this->Result.begin(); }

  void add(std::array<double, 3> point)
  {
    std::array<std::uint64_t, 3> key; // bits: NaN must not disturb the order
    for (int i = 0; i < 3; ++i)
    {
      point[i] += 0.0; // -0 is 0
      std::memcpy(&key[i], &point[i], sizeof(double));
    }
    const auto [known, isNew] = this->Known.try_emplace(key, this->Result.points());
    if (isNew)
    {
      this->Result.addPoint(point);
    }
    this->Result.add(known->second);
  }

  void noteWords(const std::vector<std::string_view>& words, std::size_t first)
  {
    this->Result.noteWords(words, first);
  }

  void end() { this->Result.end(); }

  vtkSmartPointer<vtkPolyData> take() { return this->Result.take(); }

private:
  Polygons Result;
  std::map<std::array<std::uint64_t, 3>, vtkIdType> Known;
};

/// Little endian, on any machine.
std::uint32_t wholeAt(std::string_view content, std::size_t at)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = value << 8 | static_cast<unsigned char>(content[at + i]);
  }
  return value;
}

double floatAt(std::string_view content, std::size_t at)
{
  const std::uint32_t bits = wholeAt(content, at);
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

vtkSmartPointer<vtkPolyData> readBinary(const std::string& file, std::string_view content)
{
  const std::size_t triangles = wholeAt(content, HeaderSize - 4);
  if (content.size() != HeaderSize + RowSize * triangles)
  {
    throw InputError(file + ": announces " + std::to_string(triangles) + " triangles, thus " +
      std::to_string(HeaderSize + RowSize * triangles) + " bytes, but has " +
      std::to_string(content.size()) + "; it was cut or damaged");
  }
  Corners corners(VTK_FLOAT);
  for (std::size_t at = HeaderSize; at < content.size(); at += RowSize)
  {
    corners.begin();
    for (std::size_t corner = at + 12; corner < at + 48; corner += 12)
    {
      corners.add(
        { floatAt(content, corner), floatAt(content, corner + 4), floatAt(content, corner + 8) });
    }
    corners.end();
  }
  return corners.take();
}

/// Does the line begin with these words, in small or capital letters?
bool beginsWith(const Lines& lines, std::initializer_list<std::string_view> expected)
{
  const auto isSame = [](std::string_view word, std::string_view other) {
    return std::equal(word.begin(), word.end(), other.begin(), other.end(),
      [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  };
  return lines.words().size() >= expected.size() &&
    std::equal(expected.begin(), expected.end(), lines.words().begin(),
      [&](std::string_view word, std::string_view found) { return isSame(found, word); });
}

void nextLine(Lines& lines)
{
  if (!lines.next())
  {
    throw lines.error("the file ends without endsolid; it was cut");
  }
}

/// Goes to the next line, which has to begin with these words.
void expect(Lines& lines, std::initializer_list<std::string_view> words)
{
  nextLine(lines);
  if (!beginsWith(lines, words))
  {
    std::string text;
    for (const std::string_view word : words)
    {
      text += (text.empty() ? "" : " ") + std::string(word);
    }
    throw lines.unexpected(text);
  }
}

void readFacet(Lines& lines, Corners& corners)
{
  expect(lines, { "outer", "loop" });
  corners.begin();
  for (int i = 0; i < 3; ++i)
  {
    expect(lines, { "vertex" });
    corners.add(lines.point(1, "vertex x y z"));
    corners.noteWords(lines.words(), 1);
  }
  corners.end();
  expect(lines, { "endloop" });
  expect(lines, { "endfacet" });
}

vtkSmartPointer<vtkPolyData> readAscii(const std::string& file, std::string_view content)
{
  Lines lines(file, content, Lines::Blanks);
  Corners corners(VTK_DOUBLE);
  while (lines.next()) // a solid; there may be several
  {
    if (!beginsWith(lines, { "solid" }))
    {
      throw lines.unexpected("solid");
    }
    nextLine(lines);
    for (; beginsWith(lines, { "facet", "normal" }); nextLine(lines))
    {
      readFacet(lines, corners);
    }
    if (!beginsWith(lines, { "endsolid" }) && !beginsWith(lines, { "end", "solid" }))
    {
      throw lines.unexpected("facet normal or endsolid");
    }
  }
  return corners.take();
}

/// The text at the beginning of a binary file may be "solid", too, so the size decides.
bool isBinary(std::string_view content)
{
  if (content.size() < HeaderSize)
  {
    return false;
  }
  if (content.size() == HeaderSize + RowSize * std::size_t(wholeAt(content, HeaderSize - 4)))
  {
    return true;
  }
  // Binary triangles have bytes that text has not.
  const std::string_view start = content.substr(0, HeaderSize + 4 * RowSize);
  return std::any_of(
    start.begin(), start.end(), [](unsigned char c) { return c < ' ' && !std::isspace(c); });
}
}

vtkSmartPointer<vtkPolyData> readStl(const std::string& file)
{
  const std::string content = contentOf(file);
  return isBinary(content) ? readBinary(file, content) : readAscii(file, content);
}
