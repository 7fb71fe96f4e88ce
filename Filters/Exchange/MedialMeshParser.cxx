// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/MedialMeshParser.h"

#include "Base/EdgeTable.h"
#include "Base/Errors.h"
#include "Exchange/TextLines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace medial
{
namespace
{
/// How many lines of a kind the first line announces, and how many have come.
struct LineCount
{
  char letter;
  std::size_t announced = 0, read = 0;
};

/// Takes the lines of a file in, and makes a mesh of them at the end, when all points are known.
class Parser
{
public:
  Parser(const std::string& name, std::string_view text)
    : Lines(name, text)
  {
  }

  ParsedMedialMesh parse(const Execution& execution)
  {
    this->readCounts();
    for (Index turn = 0; this->Lines.next(); turn = (turn + 1) % 4096)
    {
      this->readLine();
      if (turn == 0)
      {
        execution.report(0.8 * this->Lines.share());
      }
    }
    this->checkCounts();
    this->Base = this->firstIndex();
    execution.report(0.8);
    this->takeTriangles(execution);
    execution.report(0.9);
    this->takeEdges(execution);
    this->takeVertices();
    this->dropDeleted();
    return std::move(this->Result);
  }

private:
  MedialMesh& mesh() { return this->Result.mesh; }

  void readCounts();
  void readLine();
  void readPoint();
  void readEdge();
  void readTriangle();
  void readTetrahedron();
  template <std::size_t Size>
  std::array<Index, Size> corners(const char* expected);
  void checkCounts() const;
  Index firstIndex() const;
  void takeTriangles(const Execution& execution);
  void takeEdges(const Execution& execution);
  void takeVertices();
  void dropDeleted();

  TextLines Lines;
  std::array<LineCount, 4> Counts{ { { 'v' }, { 'e' }, { 'f' }, { 't' } } };
  bool HasCopies = false; ///< is it a .ma_dup?
  Index Base = 0;         ///< what the first point is called
  Index Highest = None;   ///< index of all cells
  bool HasZero = false;   ///< is it the index of a point in a cell?
  std::size_t HighestLine = 0;
  std::vector<char> Deleted; ///< for each point
  std::vector<Edge> Edges;
  std::vector<Index> EdgeTypes;
  std::vector<Triangle> Triangles;
  bool HasPointTypes = false, HasEdgeTypes = false;
  ParsedMedialMesh Result;
};

void Parser::readCounts()
{
  constexpr const char* expected = "the numbers of points, edges and triangles of a medial mesh";
  if (!this->Lines.next())
  {
    throw this->Lines.error(1, "the file is empty; expected ", expected, ": write the file again");
  }
  const std::size_t size = this->Lines.words().size();
  if (this->Lines.words()[0].substr(0, 6) == "//Maya")
  {
    throw this->Lines.error(this->Lines.number(),
      "this is a scene of Maya, whose files end in .ma too; take a file that begins with ",
      expected);
  }
  if (size != 3 && size != 4)
  {
    throw this->Lines.unexpected(expected);
  }
  for (std::size_t i = 0; i < size; ++i)
  {
    this->Counts[i].announced = this->Lines.size(i, expected);
  }
  this->HasCopies = size == 4;
}

void Parser::readLine()
{
  const std::string_view kind = this->Lines.words()[0];
  const auto found = std::find_if(this->Counts.begin(), this->Counts.end(),
    [&](const LineCount& line) { return kind == std::string_view(&line.letter, 1); });
  if (found == this->Counts.end() || (found->letter == 't' && !this->HasCopies))
  {
    throw this->Lines.unexpected(this->HasCopies ? "a line that begins with v, e, f or t"
                                                 : "a line that begins with v, e or f");
  }
  if (found->read == found->announced)
  {
    throw this->Lines.error(this->Lines.number(), "there are more lines that begin with ",
      found->letter, " than the ", found->announced, " that the first line announces; correct it");
  }
  ++found->read;
  switch (found->letter)
  {
    case 'v':
      return this->readPoint();
    case 'e':
      return this->readEdge();
    case 'f':
      return this->readTriangle();
    default:
      return this->readTetrahedron();
  }
}

void Parser::readPoint()
{
  const char* expected = this->HasCopies ? "v x y z r, or v x y z r type deleted copies"
                                         : "v x y z r, or v x y z r type";
  const std::size_t size = this->Lines.words().size();
  if (size != 5 && size != 6 && !(this->HasCopies && size == 8))
  {
    throw this->Lines.unexpected(expected);
  }
  const Point point(
    this->Lines.real(1, expected), this->Lines.real(2, expected), this->Lines.real(3, expected));
  const double radius = this->Lines.real(4, expected);
  const bool isDeleted = size == 8 && this->Lines.flag(6, expected);
  if (!point.allFinite() || !std::isfinite(radius) || radius < 0)
  {
    throw this->Lines.unexpected("finite coordinates and a radius of at least 0");
  }
  if (count(this->mesh().points) == MostPoints)
  {
    throw this->Lines.error(
      this->Lines.number(), "there are more than ", MostPoints, " points; divide the file");
  }
  this->HasPointTypes = this->HasPointTypes || size > 5;
  this->mesh().points.push_back(point);
  this->mesh().radii.push_back(radius);
  this->mesh().pointTypes.push_back(size > 5 ? this->Lines.whole(5, expected) : 0);
  this->Deleted.push_back(isDeleted);
}

/// The indices of a cell, as the file counts.
template <std::size_t Size>
std::array<Index, Size> Parser::corners(const char* expected)
{
  std::array<Index, Size> result;
  for (std::size_t i = 0; i < Size; ++i)
  {
    result[i] = this->Lines.index(i + 1, expected);
    if (std::find(result.begin(), result.begin() + i, result[i]) != result.begin() + i)
    {
      throw this->Lines.error(this->Lines.number(), "the point ", result[i],
        " is there twice; delete the line, and correct the numbers in the first line");
    }
    this->HasZero = this->HasZero || result[i] == 0;
    if (result[i] > this->Highest)
    {
      this->Highest = result[i];
      this->HighestLine = this->Lines.number();
    }
  }
  return result;
}

void Parser::readEdge()
{
  const char* expected =
    this->HasCopies ? "e i j, e i j type, or e i j type deleted copies" : "e i j, or e i j type";
  const std::size_t size = this->Lines.words().size();
  if (size == 5 && !this->HasCopies)
  {
    throw this->Lines.error(this->Lines.number(),
      "there are two numbers after the points of an edge; some programs mean type and deleted by "
      "them, others deleted and type: leave the deleted edges out, and write e i j type");
  }
  if (size != 3 && size != 4 && !(this->HasCopies && size == 6))
  {
    throw this->Lines.unexpected(expected);
  }
  const Edge edge = this->corners<2>(expected);
  const Index type = size > 3 ? this->Lines.whole(3, expected) : 0;
  this->HasEdgeTypes = this->HasEdgeTypes || size > 3;
  if (size < 6 || !this->Lines.flag(4, expected))
  {
    this->Edges.push_back(edge);
    this->EdgeTypes.push_back(type);
  }
}

void Parser::readTriangle()
{
  const char* expected =
    this->HasCopies ? "f i j k, or f i j k importance deleted copies" : "f i j k";
  const std::size_t size = this->Lines.words().size();
  if (size != 4 && !(this->HasCopies && size == 7))
  {
    throw this->Lines.unexpected(expected);
  }
  const Triangle triangle = this->corners<3>(expected);
  if (size == 4 || !this->Lines.flag(5, expected))
  {
    this->Triangles.push_back(triangle);
  }
}

void Parser::readTetrahedron()
{
  constexpr const char* expected = "t i j k l, or t i j k l deleted copies";
  const std::size_t size = this->Lines.words().size();
  if (size != 5 && size != 7)
  {
    throw this->Lines.unexpected(expected);
  }
  this->corners<4>(expected);
  this->Result.tetrahedra += size == 5 || !this->Lines.flag(5, expected);
}

void Parser::checkCounts() const
{
  for (const LineCount& line : this->Counts)
  {
    if (line.read != line.announced)
    {
      throw this->Lines.error(this->Lines.number(), "the file ends after ", line.read, " of ",
        line.announced, " lines that begin with ", line.letter,
        "; it was cut, or its first line is wrong: write the file again, or correct that line");
    }
  }
}

Index Parser::firstIndex() const
{
  const Index points = count(this->Deleted);
  const bool isFromOne = this->Highest == points && !this->HasZero;
  if (this->Highest >= points && !isFromOne)
  {
    throw this->Lines.error(this->HighestLine, "there is no point ", this->Highest, "; the ",
      points, " points are counted from 0: correct the line, or write the file again");
  }
  return isFromOne ? 1 : 0;
}

void Parser::takeTriangles(const Execution& execution)
{
  TriangleTable known(this->Triangles.size());
  for (Index t = 0; t < count(this->Triangles); ++t)
  {
    execution.pollAt(t);
    Triangle triangle = this->Triangles[t];
    for (Index& corner : triangle)
    {
      corner -= this->Base;
    }
    if (known.insert(triangle, t))
    {
      this->mesh().cells.triangles.push_back(triangle);
    }
    else
    {
      ++this->Result.repeated;
    }
  }
}

void Parser::takeEdges(const Execution& execution)
{
  EdgeSet sides(this->mesh().cells.triangles.size() * 3 / 2), known(this->Edges.size());
  for (const Triangle& triangle : this->mesh().cells.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      sides.insert(triangle[k], triangle[(k + 1) % 3]);
    }
  }
  for (Index e = 0; e < count(this->Edges); ++e)
  {
    execution.pollAt(e);
    const Index a = this->Edges[e][0] - this->Base, b = this->Edges[e][1] - this->Base;
    const bool isNew = !known.contains(a, b);
    this->Result.repeated += !isNew;
    known.insert(a, b);
    if (isNew && (this->EdgeTypes[e] != 0 || !sides.contains(a, b)))
    {
      this->mesh().cells.edges.push_back({ a, b });
      this->mesh().edgeTypes.push_back(this->EdgeTypes[e]);
    }
  }
  if (!this->HasEdgeTypes)
  {
    this->mesh().edgeTypes.clear();
  }
}

/// Points in no cell become vertices, unless they are deleted.
void Parser::takeVertices()
{
  std::vector<char> isUsed(this->Deleted.size(), 0);
  const auto use = [&isUsed](const auto& cells) {
    for (const auto& corners : cells)
    {
      for (const Index corner : corners)
      {
        isUsed[corner] = 1;
      }
    }
  };
  use(this->mesh().cells.edges);
  use(this->mesh().cells.triangles);
  for (Index p = 0; p < count(isUsed); ++p)
  {
    if (!isUsed[p] && !this->Deleted[p])
    {
      this->mesh().cells.vertices.push_back(p);
    }
    this->Deleted[p] = this->Deleted[p] && !isUsed[p];
  }
}

/// Leaves out the points that are deleted and in no cell.
void Parser::dropDeleted()
{
  MedialMesh& mesh = this->mesh();
  std::vector<Index> newIds(this->Deleted.size(), None);
  Index kept = 0;
  for (Index p = 0; p < count(newIds); ++p)
  {
    if (!this->Deleted[p])
    {
      mesh.points[kept] = mesh.points[p];
      mesh.radii[kept] = mesh.radii[p];
      mesh.pointTypes[kept] = mesh.pointTypes[p];
      newIds[p] = kept++;
    }
  }
  mesh.points.resize(kept);
  mesh.radii.resize(kept);
  mesh.pointTypes.resize(this->HasPointTypes ? kept : 0);
  const auto renumber = [&newIds](auto& corners) {
    for (Index& corner : corners)
    {
      corner = newIds[corner];
    }
  };
  renumber(mesh.cells.vertices);
  std::for_each(mesh.cells.edges.begin(), mesh.cells.edges.end(), renumber);
  std::for_each(mesh.cells.triangles.begin(), mesh.cells.triangles.end(), renumber);
}
}

ParsedMedialMesh parsedMedialMesh(
  const std::string& name, std::string_view text, const Execution& execution)
{
  return Parser(name, text).parse(execution);
}
}
