// SPDX-License-Identifier: BSD-3-Clause
#include "ReadObj.h"

#include "Lines.h"
#include "Polygons.h"

#include <algorithm>

namespace
{
/// What a corner of a face names: a point, its texture coordinates, its normal.
constexpr std::array<const char*, 3> Kinds = { "v", "vt", "vn" };

/// The other statements of the format. A line that begins otherwise is damaged, and might have been a
/// point.
constexpr const char* Others[] = { "vp", "p", "l", "fo", "o", "g", "s", "mg", "usemtl", "mtllib",
  "usemap", "maplib", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech",
  "stech", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
  "sp", "end", "con", "call", "csh", "bsp", "bzp", "cdc", "cdp", "res" };

/// A face names what may stand later in the file, so its indices are checked at the end.
struct Largest
{
  long long index = 0; ///< the largest that a face names, from 1 on
  long line = 0;
};

/// How many there are of each kind so far, and what the faces ask for.
struct Counts
{
  std::array<long long, 3> known = {};
  std::array<Largest, 3> asked;
};

/// One index of a corner: from 1 on, or backwards from -1. Returns it from 1 on.
long long index(const Lines& lines, std::string_view text, std::size_t kind, Counts& counts)
{
  const bool isBackwards = !text.empty() && text[0] == '-';
  long long value = 0;
  if (!parseWhole(text.substr(isBackwards ? 1 : 0), value) || value == 0 ||
    (isBackwards && value > counts.known[kind]))
  {
    throw lines.unexpected(
      std::string("a face whose corners name existing ") + Kinds[kind] + ", numbered from 1");
  }
  value = isBackwards ? counts.known[kind] + 1 - value : value;
  if (value > counts.asked[kind].index)
  {
    counts.asked[kind] = { value, lines.number() };
  }
  return value;
}

/// Reads v, v/vt, v//vn or v/vt/vn; returns the point, from 1 on.
long long corner(const Lines& lines, std::string_view word, Counts& counts)
{
  long long point = 0;
  std::size_t kind = 0;
  for (bool more = true; more; ++kind)
  {
    const std::size_t slash = std::min(word.find('/'), word.size());
    const std::string_view text = word.substr(0, slash);
    more = slash < word.size();
    word.remove_prefix(more ? slash + 1 : slash);
    if (kind >= Kinds.size())
    {
      throw lines.unexpected("a face with corners as 1, 1/2, 1//3 or 1/2/3");
    }
    if (!text.empty() || kind == 0) // 1// and 1/ name neither
    {
      const long long value = index(lines, text, kind, counts);
      point = kind == 0 ? value : point;
    }
  }
  return point;
}

void readFace(const Lines& lines, Counts& counts, Polygons& polygons)
{
  if (lines.words().size() < 4)
  {
    throw lines.unexpected("a face with at least three corners");
  }
  polygons.begin();
  std::for_each(lines.words().begin() + 1, lines.words().end(), [&](std::string_view word) {
    polygons.add(static_cast<vtkIdType>(corner(lines, word, counts) - 1));
  });
  polygons.end();
}

void readStatement(const Lines& lines, Counts& counts, Polygons& polygons)
{
  const std::string_view keyword = lines.words()[0];
  if (keyword == "v")
  {
    polygons.addPoint(lines.point(1, "v x y z"));
    polygons.noteWords(lines.words(), 1);
    ++counts.known[0];
  }
  else if (keyword == "vt" || keyword == "vn")
  {
    ++counts.known[keyword == "vt" ? 1 : 2];
  }
  else if (keyword == "f")
  {
    readFace(lines, counts, polygons);
  }
  else if (std::find(std::begin(Others), std::end(Others), keyword) == std::end(Others))
  {
    throw lines.unexpected("a statement of .obj files, such as v x y z");
  }
}

void checkIndices(const std::string& file, const Counts& counts)
{
  for (std::size_t kind = 0; kind < Kinds.size(); ++kind)
  {
    const Largest& asked = counts.asked[kind];
    if (asked.index > counts.known[kind])
    {
      throw InputError(file + ", line " + std::to_string(asked.line) + ": a face names " +
        Kinds[kind] + " " + std::to_string(asked.index) + ", but there are only " +
        std::to_string(counts.known[kind]) + "; the file was cut, or the number is wrong");
    }
  }
}
}

vtkSmartPointer<vtkPolyData> readObj(const std::string& file)
{
  const std::string content = contentOf(file);
  Lines lines(file, content, Lines::BlanksComments);
  Polygons polygons(VTK_DOUBLE);
  Counts counts;
  while (lines.next())
  {
    while (lines.isContinued())
    {
      lines.append();
    }
    if (!lines.words().empty())
    {
      readStatement(lines, counts, polygons);
    }
  }
  checkIndices(file, counts);
  return polygons.take();
}
