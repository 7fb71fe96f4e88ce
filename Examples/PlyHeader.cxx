// SPDX-License-Identifier: BSD-3-Clause
#include "PlyHeader.h"

#include "Lines.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr std::pair<const char*, PlyType> TypeNames[] = {
  { "char", PlyType::Int8 },
  { "int8", PlyType::Int8 },
  { "uchar", PlyType::UInt8 },
  { "uint8", PlyType::UInt8 },
  { "short", PlyType::Int16 },
  { "int16", PlyType::Int16 },
  { "ushort", PlyType::UInt16 },
  { "uint16", PlyType::UInt16 },
  { "int", PlyType::Int32 },
  { "int32", PlyType::Int32 },
  { "uint", PlyType::UInt32 },
  { "uint32", PlyType::UInt32 },
  { "float", PlyType::Float32 },
  { "float32", PlyType::Float32 },
  { "double", PlyType::Float64 },
  { "float64", PlyType::Float64 },
};

constexpr std::pair<const char*, PlyFormat> FormatNames[] = {
  { "ascii", PlyFormat::Ascii },
  { "binary_little_endian", PlyFormat::LittleEndian },
  { "binary_big_endian", PlyFormat::BigEndian },
};

/// The word at a place of the line, or nothing.
std::string_view word(const Lines& lines, std::size_t place)
{
  return place < lines.words().size() ? lines.words()[place] : std::string_view();
}

template <typename Table>
auto lookUp(const Lines& lines, std::size_t place, const Table& table, const std::string& expected)
{
  const auto found = std::find_if(std::begin(table), std::end(table),
    [&](const auto& row) { return word(lines, place) == row.first; });
  if (found == std::end(table))
  {
    throw lines.unexpected(expected);
  }
  return found->second;
}

PlyFormat format(const Lines& lines)
{
  const std::string expected = "format ascii, binary_little_endian or binary_big_endian, and 1.0";
  if (word(lines, 2) != "1.0" || lines.words().size() != 3)
  {
    throw lines.unexpected(expected);
  }
  return lookUp(lines, 1, FormatNames, expected);
}

PlyElement element(const Lines& lines, const PlyHeader& header)
{
  PlyElement result{ std::string(word(lines, 1)), 0, {} };
  if (lines.words().size() != 3 || !parseWhole(word(lines, 2), result.count))
  {
    throw lines.unexpected("element, its name and its number of rows");
  }
  if (header.find(result.name))
  {
    throw lines.error("there are two elements " + result.name);
  }
  return result;
}

/// "property float x" or "property list uchar int vertex_indices"
PlyProperty property(const Lines& lines)
{
  const std::string expected = "property, its type (char uchar short ushort int uint float double) "
                               "and its name";
  const bool isList = word(lines, 1) == "list";
  const std::size_t type = isList ? 3 : 1;
  if (lines.words().size() != type + 2)
  {
    throw lines.unexpected(expected);
  }
  PlyProperty result{ std::string(word(lines, type + 1)), lookUp(lines, type, TypeNames, expected),
    {} };
  if (isList)
  {
    result.countType = lookUp(lines, 2, TypeNames, expected);
    if (*result.countType == PlyType::Float32 || *result.countType == PlyType::Float64)
    {
      throw lines.error("the length of a list can't be a " + std::string(word(lines, 2)));
    }
  }
  return result;
}

void addProperty(const Lines& lines, PlyHeader& header)
{
  if (header.elements.empty())
  {
    throw lines.error("a property before any element");
  }
  std::vector<PlyProperty>& properties = header.elements.back().properties;
  PlyProperty added = property(lines);
  if (std::any_of(properties.begin(), properties.end(),
        [&](const PlyProperty& known) { return known.name == added.name; }))
  {
    throw lines.error("there are two properties " + added.name);
  }
  properties.push_back(std::move(added));
}

/// Where the body begins. All lines of the header end like the first one; in a binary file the next byte
/// may look like the end of a line.
std::size_t bodyAfter(const Lines& lines, std::string_view content)
{
  const std::size_t first = content.find_first_of("\r\n");
  const bool isPair = content.substr(first, 2) == "\r\n";
  const bool endsAsPair = lines.end() >= 2 && content.substr(lines.end() - 2, 2) == "\r\n";
  return !isPair && endsAsPair ? lines.end() - 1 : lines.end();
}

/// @throw InputError  an element has rows of nothing
void checkElements(const std::string& file, const PlyHeader& header)
{
  for (const PlyElement& element : header.elements)
  {
    if (element.properties.empty() && element.count > 0)
    {
      throw InputError(file + ": the element " + element.name + " has rows but no properties");
    }
  }
}
}

const PlyElement* PlyHeader::find(const std::string& name) const
{
  const auto found = std::find_if(this->elements.begin(), this->elements.end(),
    [&](const PlyElement& element) { return element.name == name; });
  return found == this->elements.end() ? nullptr : &*found;
}

std::size_t sizeOf(PlyType type)
{
  constexpr std::size_t sizes[] = { 1, 1, 2, 2, 4, 4, 4, 8 };
  return sizes[static_cast<int>(type)];
}

PlyHeader plyHeader(const std::string& file, std::string_view content)
{
  Lines lines(file, content, Lines::Blanks);
  if (!lines.next() || word(lines, 0) != "ply" || lines.words().size() != 1)
  {
    throw lines.error("not a .ply file: it doesn't begin with ply");
  }
  PlyHeader header{ PlyFormat::Ascii, {}, 0, 0 };
  if (!lines.next() || word(lines, 0) != "format")
  {
    throw lines.error("the second line of a .ply file tells its format");
  }
  header.format = format(lines);
  while (lines.next())
  {
    if (word(lines, 0) == "end_header")
    {
      header.end = bodyAfter(lines, content);
      header.lines = lines.number();
      checkElements(file, header);
      return header;
    }
    if (word(lines, 0) == "element")
    {
      header.elements.push_back(element(lines, header));
    }
    else if (word(lines, 0) == "property")
    {
      addProperty(lines, header);
    }
    else if (word(lines, 0) != "comment" && word(lines, 0) != "obj_info")
    {
      throw lines.unexpected("element, property, comment or end_header");
    }
  }
  throw lines.error("the header doesn't end (end_header); the file was cut");
}
