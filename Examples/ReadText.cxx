// SPDX-License-Identifier: BSD-3-Clause
#include "ReadText.h"

#include "Errors.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace
{
/// Reads a text file line by line and skips comments and empty lines.
class Lines
{
public:
  explicit Lines(const std::string& file)
    : File(file)
    , Stream(file, std::ios::binary)
  {
  }

  /// Goes to the next line that is not empty; returns false at the end of the file.
  bool next()
  {
    while (std::getline(this->Stream, this->Line))
    {
      ++this->Number;
      this->Line.erase(std::min(this->Line.find('#'), this->Line.size()));
      std::replace_if(
        this->Line.begin(), this->Line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
      if (this->Line.find_first_not_of(" \t\r\f\v") != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }

  const std::string& line() const { return this->Line; }

  /// The first three numbers of the line.
  std::array<double, 3> numbers(const char* what) const
  {
    std::array<double, 3> values;
    const char* at = this->Line.c_str();
    for (double& value : values)
    {
      char* end = nullptr;
      value = std::strtod(at, &end);
      if (end == at || (*end != '\0' && !std::isspace(static_cast<unsigned char>(*end))))
      {
        throw this->error(std::string("expected ") + what + ", found '" + this->start() + "'");
      }
      at = end;
    }
    return values;
  }

  InputError error(const std::string& message) const
  {
    return InputError(this->File + ", line " + std::to_string(this->Number) + ": " + message);
  }

private:
  /// The line as error messages show it.
  std::string start() const
  {
    std::string text = this->Line.substr(0, 40);
    std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  }

  std::string File;
  std::ifstream Stream;
  std::string Line;
  long Number = 0;
};

/// Checks the keyword of an .off file and removes it. The rest of the line has the counts or is empty.
std::string withoutKeyword(const Lines& lines)
{
  std::istringstream words(lines.line());
  std::string keyword;
  words >> keyword;
  const std::size_t size = keyword.size();
  if (size < 3 || keyword.compare(size - 3, 3, "OFF") != 0 ||
    keyword.find_first_not_of("STCNOF") != std::string::npos)
  {
    throw lines.error("not an .off file of points in space: it doesn't begin with OFF");
  }
  std::string rest;
  std::getline(words, rest);
  if (rest.find("BINARY") != std::string::npos)
  {
    throw lines.error("binary .off files can't be read; convert it to .ply or to ASCII");
  }
  return rest;
}

/// The number of points, which stands after the keyword or in the next line.
vtkIdType readPointCount(Lines& lines)
{
  if (!lines.next())
  {
    throw lines.error("the file is empty");
  }
  double points = 0;
  std::istringstream rest(withoutKeyword(lines));
  if (!(rest >> points))
  {
    if (!lines.next())
    {
      throw lines.error("the numbers of points, faces and edges are missing");
    }
    std::istringstream counts(lines.line());
    counts >> points;
    if (!counts)
    {
      points = -1;
    }
  }
  if (!(points >= 0 && points < 2147483647) || points != static_cast<vtkIdType>(points))
  {
    throw lines.error("the number of points can't be read");
  }
  return static_cast<vtkIdType>(points);
}

vtkSmartPointer<vtkPoints> doublePoints()
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  return points;
}
}

vtkSmartPointer<vtkPoints> readOff(const std::string& file)
{
  Lines lines(file);
  const vtkIdType count = readPointCount(lines);
  auto points = doublePoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!lines.next())
    {
      throw lines.error(
        "the file ends after " + std::to_string(i) + " of " + std::to_string(count) + " points");
    }
    points->InsertNextPoint(lines.numbers("x y z of a point").data());
  }
  return points;
}

vtkSmartPointer<vtkPoints> readXyz(const std::string& file)
{
  Lines lines(file);
  auto points = doublePoints();
  while (lines.next())
  {
    points->InsertNextPoint(lines.numbers("x y z").data());
  }
  return points;
}
