// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlyHeader_h
#define PlyHeader_h

#include <optional>
#include <string>
#include <string_view>
#include <vector>

enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

enum class PlyFormat
{
  Ascii,
  LittleEndian,
  BigEndian
};

/// A value that each row of an element has, or a list of values.
struct PlyProperty
{
  std::string name;
  PlyType type;                     ///< of the value or of each value in the list
  std::optional<PlyType> countType; ///< a list: of the number before the values
};

/// A table of the file, such as "vertex" or "face".
struct PlyElement
{
  std::string name;
  long long count; ///< rows, as the file says: not checked against its size
  std::vector<PlyProperty> properties;
};

struct PlyHeader
{
  PlyFormat format;
  std::vector<PlyElement> elements;
  std::size_t end; ///< the first byte after it
  long lines;      ///< of the header

  /// The element of this name, or null.
  const PlyElement* find(const std::string& name) const;
};

/// Bytes of a value in a binary file.
std::size_t sizeOf(PlyType type);

/// Reads the header of a .ply file.
/// @param file     its name, for errors
/// @throw InputError  names the line that contradicts the format
PlyHeader plyHeader(const std::string& file, std::string_view content);

#endif
