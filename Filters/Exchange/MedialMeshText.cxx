// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/MedialMeshText.h"

#include "Base/EdgeTable.h"

#include <array>
#include <charconv>
#include <utility>

namespace medial
{
namespace
{
/// Puts lines of words together.
class Writing
{
public:
  explicit Writing(const Execution& execution)
    : Run(execution)
  {
  }

  /// Adds a number after a blank: of a double as many digits as tell it from all others.
  template <typename Number>
  void add(Number number)
  {
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.begin(), digits.end(), number);
    this->Text += ' ';
    this->Text.append(digits.begin(), end);
  }

  void begin(char letter) { this->Text += letter; }

  void end()
  {
    this->Text += '\n';
    this->Run.pollAt(this->Line++ % 4096);
  }

  template <typename Corners>
  void addCell(char letter, const Corners& corners, const std::vector<Index>& newIds)
  {
    this->begin(letter);
    for (const Index corner : corners)
    {
      this->add(newIds[corner]);
    }
  }

  void addCounts(Index points, std::size_t edges, std::size_t triangles)
  {
    this->Text =
      std::to_string(points) + ' ' + std::to_string(edges) + ' ' + std::to_string(triangles);
    this->end();
  }

  std::string take() { return std::move(this->Text); }

private:
  const Execution& Run;
  std::string Text;
  std::size_t Line = 0;
};

/// For each point its number among those that cells use, None if none does.
std::vector<Index> usedPoints(const MedialMesh& mesh, Index& usedCount)
{
  std::vector<Index> result(mesh.points.size(), None);
  const auto use = [&result](const auto& cells) {
    for (const auto& corners : cells)
    {
      for (const Index corner : corners)
      {
        result[corner] = 0;
      }
    }
  };
  use(mesh.cells.edges);
  use(mesh.cells.triangles);
  use(std::array{ mesh.cells.vertices });
  usedCount = 0;
  for (Index& number : result)
  {
    number = number == None ? None : usedCount++;
  }
  return result;
}

/// The sides of triangles that are no edges of the mesh, each once.
std::vector<Edge> sidesOf(const AxisCells& cells, const Execution& execution)
{
  EdgeSet known(cells.edges.size() + cells.triangles.size() * 3 / 2);
  for (const Edge& edge : cells.edges)
  {
    known.insert(edge[0], edge[1]);
  }
  std::vector<Edge> result;
  for (Index t = 0; t < count(cells.triangles); ++t)
  {
    execution.pollAt(t);
    for (int k = 0; k < 3; ++k)
    {
      const Index a = cells.triangles[t][k], b = cells.triangles[t][(k + 1) % 3];
      if (!known.contains(a, b))
      {
        known.insert(a, b);
        result.push_back({ a, b });
      }
    }
  }
  return result;
}

void addPoints(Writing& text, const MedialMesh& mesh, const std::vector<Index>& newIds)
{
  for (Index p = 0; p < count(mesh.points); ++p)
  {
    if (newIds[p] == None)
    {
      continue;
    }
    text.begin('v');
    for (const double coordinate : mesh.points[p])
    {
      text.add(coordinate);
    }
    text.add(mesh.radii[p]);
    if (!mesh.pointTypes.empty())
    {
      text.add(mesh.pointTypes[p]);
    }
    text.end();
  }
}

void addEdges(Writing& text, const MedialMesh& mesh, const std::vector<Edge>& sides,
  const std::vector<Index>& newIds)
{
  for (Index e = 0; e < count(mesh.cells.edges); ++e)
  {
    text.addCell('e', mesh.cells.edges[e], newIds);
    if (!mesh.edgeTypes.empty())
    {
      text.add(mesh.edgeTypes[e]);
    }
    text.end();
  }
  for (const Edge& side : sides)
  {
    text.addCell('e', side, newIds);
    if (!mesh.edgeTypes.empty())
    {
      text.add(0);
    }
    text.end();
  }
}
}

std::string textOf(const MedialMesh& mesh, const Execution& execution)
{
  Index pointCount = 0;
  const std::vector<Index> newIds = usedPoints(mesh, pointCount);
  execution.report(0.1);
  const std::vector<Edge> sides = sidesOf(mesh.cells, execution);
  execution.report(0.3);
  Writing text(execution);
  text.addCounts(pointCount, mesh.cells.edges.size() + sides.size(), mesh.cells.triangles.size());
  addPoints(text, mesh, newIds);
  execution.report(0.6);
  addEdges(text, mesh, sides, newIds);
  execution.report(0.8);
  for (const Triangle& triangle : mesh.cells.triangles)
  {
    text.addCell('f', triangle, newIds);
    text.end();
  }
  return text.take();
}
}
