// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/OutsideCounts.h"
#include "CloudSites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using medial::BoundaryPiece;
using medial::Index;
using medial::None;
using medial::OutsideCounts;
using medial::SiteTriangulation;

namespace
{
/// The closed piece of the boundary with some vertices, edges and facets, given as bits, and their faces.
struct Closed
{
  std::array<bool, 4> vertices{};
  std::array<bool, 6> edges{};
  int facets = 0;

  explicit Closed(int bits)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->vertices[i] = (bits >> i & 1) != 0;
      this->facets += bits >> (10 + i) & 1;
    }
    for (int k = 0; k < 6; ++k)
    {
      this->edges[k] = (bits >> (4 + k) & 1) != 0;
      for (int i = 0; i < 4; ++i)
      {
        this->edges[k] |= (bits >> (10 + i) & 1) != 0 && medial::isInFacet(k, i);
      }
      for (const int end : medial::cellEdges[k])
      {
        this->vertices[end] |= this->edges[k];
      }
    }
  }

  /// Adds the vertices and edges that a cell shares with others.
  template <typename Corners>
  void shareWith(const medial::Tetrahedron& cell, const Corners& others)
  {
    const auto isShared = [&](int i) {
      return std::count(others.begin(), others.end(), cell[i]) != 0;
    };
    for (int i = 0; i < 4; ++i)
    {
      this->vertices[i] |= isShared(i);
    }
    for (int k = 0; k < 6; ++k)
    {
      this->edges[k] |= isShared(medial::cellEdges[k][0]) && isShared(medial::cellEdges[k][1]);
    }
  }
};

/// What a cell shares with other cells that are not in a set, and with the hull, by looking at all.
Closed sharedByAll(const SiteTriangulation& sites, const std::vector<char>& isIn, Index cell)
{
  Closed result(0);
  const medial::Tetrahedron& corners = sites.mesh.cells[cell];
  for (Index c = 0; c < medial::count(sites.mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (sites.mesh.neighbors[c][i] == None)
      {
        result.shareWith(corners, medial::facet(sites.mesh.cells[c], i));
      }
    }
    if (c != cell && !isIn[c])
    {
      result.shareWith(corners, sites.mesh.cells[c]);
    }
  }
  for (const Index n : sites.mesh.neighbors[cell])
  {
    result.facets += n == None || !isIn[n];
  }
  return result;
}
}

TEST(OutsideCounts, AKnownPieceOfTheBoundary)
{
  const auto piece = [](int bits) {
    const Closed closed(bits);
    return medial::boundaryPiece(closed.vertices, closed.edges, closed.facets);
  };
  const auto expect = [&](int bits, int components, int loops) {
    EXPECT_EQ(piece(bits).components, components);
    EXPECT_EQ(piece(bits).loops, loops);
    EXPECT_EQ(piece(bits).isContractible(), components == 1 && loops == 0);
  };
  expect(0, 0, 0);                // nothing
  expect(0b0001, 1, 0);           // a vertex
  expect(0b1001, 2, 0);           // two
  expect(0b1111, 4, 0);           // all four
  expect(0b100001 << 4, 2, 0);    // two opposite edges
  expect(0b001011 << 4, 1, 1);    // three edges around a facet
  expect(0b111111 << 4, 1, 3);    // all edges
  expect(1 << 10, 1, 0);          // a facet
  expect(1 << 10 | 0b0001, 2, 0); // a facet and the vertex opposite to it
  expect(0b0111 << 10, 1, 0);     // three facets
  expect(0b1111 << 10, 1, -1);    // the whole boundary
}

TEST(OutsideCounts, ThePieceAndTheRestOfTheBoundaryFitTogether)
{
  // By Alexander duality in the sphere: the rest of a piece has one component more than it has loops.
  for (int bits = 0; bits < 1 << 14; ++bits)
  {
    const Closed closed(bits);
    const BoundaryPiece piece = medial::boundaryPiece(closed.vertices, closed.edges, closed.facets);
    if (piece.components == 0 || closed.facets == 4)
    {
      continue;
    }
    // Components of the rest: open facets, joined over open edges.
    int component[4] = { 0, 1, 2, 3 };
    int rest = 0;
    std::array<bool, 4> isOpen{};
    for (int i = 0; i < 4; ++i)
    {
      isOpen[i] = (bits >> (10 + i) & 1) == 0;
      rest += isOpen[i];
    }
    for (int k = 0; k < 6; ++k)
    {
      int sides[2], n = 0;
      for (int i = 0; i < 4; ++i)
      {
        if (medial::isInFacet(k, i))
        {
          sides[n++] = component[i];
        }
      }
      if (!closed.edges[k] && sides[0] != sides[1])
      {
        std::replace(component, component + 4, sides[1], sides[0]);
        --rest;
      }
    }
    ASSERT_EQ(rest, piece.loops + 1) << "bits " << bits;
  }
}

TEST(OutsideCounts, CountsWhileCellsComeAndGo)
{
  const SiteTriangulation sites = cloudSites(60, 4);
  const Index cells = medial::count(sites.mesh.cells);
  std::vector<char> isIn(cells, 0);
  OutsideCounts outside(sites);
  std::mt19937 random(1);
  for (int turn = 0; turn < 2000; ++turn)
  {
    const Index cell = static_cast<Index>(random() % cells);
    isIn[cell] ? outside.putOut(cell) : outside.takeIn(cell);
    isIn[cell] = !isIn[cell];
    const Index tested = static_cast<Index>(random() % cells);
    if (!isIn[tested])
    {
      const Closed expected = sharedByAll(sites, isIn, tested);
      const BoundaryPiece a = outside.sharedWithOthers(tested, expected.facets);
      const BoundaryPiece b =
        medial::boundaryPiece(expected.vertices, expected.edges, expected.facets);
      ASSERT_EQ(a.components, b.components) << "turn " << turn;
      ASSERT_EQ(a.loops, b.loops) << "turn " << turn;
    }
  }
}
