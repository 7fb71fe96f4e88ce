// SPDX-License-Identifier: BSD-3-Clause
#include "ReadPly.h"

#include "Lines.h"
#include "PlyHeader.h"
#include "Polygons.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <utility>

namespace
{
/// Gives the values of the rows one after another.
class Rows
{
public:
  virtual ~Rows() = default;

  virtual void begin(const PlyElement& element, long long row) = 0;
  /// The next value of the row, or of its list.
  virtual double value(PlyType type) = 0;
  /// The word that it was, in a text; empty in binary.
  virtual std::string_view word() const = 0;
  /// How many more values the row can have.
  virtual std::size_t rest(PlyType type) const = 0;
  virtual void end() = 0;
  /// @throw InputError  there is more than the header announces
  virtual void finish() = 0;
  /// An error in this row.
  virtual InputError error(const std::string& message) const = 0;
};

/// Each row is a line.
class AsciiRows : public Rows
{
public:
  AsciiRows(const std::string& file, std::string_view content, const PlyHeader& header)
    : Text(file, content, Lines::Blanks, header.end, header.lines + 1)
  {
  }

  void begin(const PlyElement& element, long long row) override
  {
    if (!this->Text.next())
    {
      throw this->Text.error("the file ends after " + std::to_string(row) + " of " +
        std::to_string(element.count) + " rows of the element " + element.name +
        "; it was cut, or the header's number is wrong");
    }
    this->Expected = "the values of a row of the element " + element.name;
    this->Place = 0;
  }

  double value(PlyType) override { return this->Text.real(this->Place++, this->Expected.c_str()); }

  std::string_view word() const override { return this->Text.words()[this->Place - 1]; }

  std::size_t rest(PlyType) const override { return this->Text.words().size() - this->Place; }

  void end() override
  {
    if (this->Place != this->Text.words().size())
    {
      throw this->Text.unexpected(
        this->Expected + " (" + std::to_string(this->Place) + " numbers)");
    }
  }

  void finish() override
  {
    if (this->Text.next())
    {
      throw this->Text.error("more rows than the header announces; correct its numbers of rows");
    }
  }

  InputError error(const std::string& message) const override { return this->Text.error(message); }

private:
  Lines Text;
  std::string Expected;
  std::size_t Place = 0; ///< of the next word
};

template <typename Value>
double valueOf(std::array<char, 8> bytes)
{
  Value value;
  std::memcpy(&value, bytes.data(), sizeof(Value));
  return static_cast<double>(value);
}

class BinaryRows : public Rows
{
public:
  BinaryRows(std::string file, std::string_view content, const PlyHeader& header)
    : File(std::move(file))
    , Content(content)
    , At(header.end)
    , IsSwapped((header.format == PlyFormat::BigEndian) != isBigEndian())
  {
  }

  void begin(const PlyElement& element, long long row) override
  {
    this->Element = &element;
    this->Row = row;
  }

  std::string_view word() const override { return {}; }

  double value(PlyType type) override
  {
    const std::size_t size = sizeOf(type);
    if (this->rest(type) == 0)
    {
      throw this->error("the file ends here, " + std::to_string(this->Element->count) +
        " rows are announced; it was cut, or the header's number is wrong");
    }
    std::array<char, 8> bytes = {};
    std::copy_n(this->Content.begin() + this->At, size, bytes.begin());
    if (this->IsSwapped)
    {
      std::reverse(bytes.begin(), bytes.begin() + size);
    }
    this->At += size;
    using Convert = double (*)(std::array<char, 8>);
    constexpr Convert convert[] = { valueOf<std::int8_t>, valueOf<std::uint8_t>,
      valueOf<std::int16_t>, valueOf<std::uint16_t>, valueOf<std::int32_t>, valueOf<std::uint32_t>,
      valueOf<float>, valueOf<double> };
    return convert[static_cast<int>(type)](bytes);
  }

  std::size_t rest(PlyType type) const override
  {
    return (this->Content.size() - this->At) / sizeOf(type);
  }

  void end() override {}

  void finish() override
  {
    // Some writers end a file like a line.
    if (this->Content.find_first_not_of("\r\n", this->At) != std::string_view::npos)
    {
      throw InputError(this->File + ", byte " + std::to_string(this->At) + ": " +
        std::to_string(this->Content.size() - this->At) +
        " bytes more than the header announces; correct its numbers of rows or its types");
    }
  }

  InputError error(const std::string& message) const override
  {
    return InputError(this->File + ", row " + std::to_string(this->Row) + " of the element " +
      this->Element->name + ", byte " + std::to_string(this->At) + ": " + message);
  }

private:
  static bool isBigEndian()
  {
    const std::uint16_t one = 1;
    char first = 0;
    std::memcpy(&first, &one, 1);
    return first == 0;
  }

  std::string File;
  std::string_view Content;
  std::size_t At; ///< the next byte
  bool IsSwapped;
  const PlyElement* Element = nullptr;
  long long Row = 0;
};

/// The length of a list, no longer than what is left of the row or file.
std::size_t listLength(const PlyProperty& property, Rows& rows)
{
  const double length = rows.value(*property.countType);
  if (!(length >= 0) || length != std::floor(length) ||
    length > static_cast<double>(rows.rest(property.type)))
  {
    throw rows.error("the list " + property.name + " can't have its announced length; " +
      std::to_string(rows.rest(property.type)) + " values follow");
  }
  return static_cast<std::size_t>(length);
}

/// Reads past a property.
void skip(const PlyProperty& property, Rows& rows)
{
  const std::size_t length = property.countType ? listLength(property, rows) : 1;
  for (std::size_t i = 0; i < length; ++i)
  {
    rows.value(property.type);
  }
}

/// The number of a property that is one value, or the number of all properties where there is none.
std::size_t placeOf(const PlyElement& vertices, const std::string& name)
{
  const auto found = std::find_if(vertices.properties.begin(), vertices.properties.end(),
    [&](const PlyProperty& property) { return property.name == name && !property.countType; });
  return found - vertices.properties.begin();
}

using Names = std::array<const char*, 3>;

/// For each property of the vertices which of three names it has, 0 to 2, or -1.
std::vector<int> placesOf(const PlyElement& vertices, const Names& names)
{
  std::vector<int> result(vertices.properties.size() + 1, -1);
  for (int axis = 0; axis < 3; ++axis)
  {
    result[placeOf(vertices, names[axis])] = axis;
  }
  result.pop_back();
  return result;
}

/// Where the properties of the vertices go.
struct VertexPlaces
{
  std::vector<int> coordinates; ///< for each property the coordinate it is, 0 to 2, or -1
  std::vector<int> normals;     ///< the same of normals
  bool hasNormals;
};

VertexPlaces vertexPlaces(const std::string& file, const PlyElement& vertices)
{
  const Names coordinates = { "x", "y", "z" }, normals = { "nx", "ny", "nz" };
  const auto isMissing = [&](const char* name) {
    return placeOf(vertices, name) == vertices.properties.size();
  };
  for (const char* name : coordinates)
  {
    if (isMissing(name))
    {
      throw InputError(file + ": its vertices have no " + name + "; they need x, y and z");
    }
  }
  return { placesOf(vertices, coordinates), placesOf(vertices, normals),
    std::none_of(normals.begin(), normals.end(), isMissing) };
}

void readVertex(
  const PlyElement& vertices, const VertexPlaces& places, Rows& rows, Polygons& polygons)
{
  std::array<double, 3> point = {}, normal = {};
  for (std::size_t k = 0; k < vertices.properties.size(); ++k)
  {
    if (places.coordinates[k] >= 0)
    {
      point[places.coordinates[k]] = rows.value(vertices.properties[k].type);
      polygons.noteWord(rows.word());
    }
    else if (places.normals[k] >= 0)
    {
      normal[places.normals[k]] = rows.value(vertices.properties[k].type);
    }
    else
    {
      skip(vertices.properties[k], rows);
    }
  }
  polygons.addPoint(point);
  if (places.hasNormals)
  {
    polygons.addNormal(normal);
  }
}

void readFace(const PlyElement& faces, long long points, Rows& rows, Polygons& polygons)
{
  for (const PlyProperty& property : faces.properties)
  {
    const bool isFace = property.name == "vertex_indices" || property.name == "vertex_index";
    if (!isFace || !property.countType)
    {
      skip(property, rows);
      continue;
    }
    const std::size_t length = listLength(property, rows);
    polygons.begin();
    for (std::size_t i = 0; i < length; ++i)
    {
      const double index = rows.value(property.type);
      if (!(index >= 0 && index < static_cast<double>(points)) || index != std::floor(index))
      {
        throw rows.error("a face has a corner that does not exist; the " + std::to_string(points) +
          " vertices are numbered from 0");
      }
      polygons.add(static_cast<vtkIdType>(index));
    }
    polygons.end();
  }
}

void readElements(const std::string& file, const PlyHeader& header, Rows& rows, Polygons& polygons)
{
  const PlyElement& vertices = *header.find("vertex");
  const VertexPlaces places = vertexPlaces(file, vertices);
  for (const PlyElement& element : header.elements)
  {
    for (long long row = 0; row < element.count; ++row)
    {
      rows.begin(element, row);
      if (&element == &vertices)
      {
        readVertex(element, places, rows, polygons);
      }
      else if (element.name == "face")
      {
        readFace(element, vertices.count, rows, polygons);
      }
      else
      {
        std::for_each(element.properties.begin(), element.properties.end(),
          [&](const PlyProperty& property) { skip(property, rows); });
      }
      rows.end();
    }
  }
  rows.finish();
}

/// Are all coordinates floats in binary? Digits of text may say more than a float holds.
int coordinateType(const PlyHeader& header)
{
  const std::vector<PlyProperty>& all = header.find("vertex")->properties;
  const bool isFloat = header.format != PlyFormat::Ascii &&
    std::none_of(all.begin(), all.end(), [](const PlyProperty& property) {
      const bool isCoordinate =
        property.name == "x" || property.name == "y" || property.name == "z";
      return isCoordinate && property.type != PlyType::Float32;
    });
  return isFloat ? VTK_FLOAT : VTK_DOUBLE;
}
}

vtkSmartPointer<vtkPolyData> readPly(const std::string& file)
{
  const std::string content = contentOf(file);
  const PlyHeader header = plyHeader(file, content);
  if (!header.find("vertex"))
  {
    throw InputError(file + ": it has no element vertex, thus no points");
  }
  std::unique_ptr<Rows> rows;
  if (header.format == PlyFormat::Ascii)
  {
    rows = std::make_unique<AsciiRows>(file, content, header);
  }
  else
  {
    rows = std::make_unique<BinaryRows>(file, content, header);
  }
  Polygons polygons(coordinateType(header));
  readElements(file, header, *rows, polygons);
  return polygons.take();
}
