// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/MissedDetails.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <algorithm>

namespace medial
{
namespace
{
constexpr double few = 20; // samples of a whole piece

/// Triangles of the pieces that are chosen, by the number of the piece.
/// @param isChosen  by the lowest point and the area of a piece
template <typename Predicate>
std::vector<Detail> chosenPieces(
  const TriangleSet& surface, const std::vector<Index>& pieces, const Predicate& isChosen)
{
  constexpr Index most = 32; // of a piece
  const IndexLists trianglesOf = listsByKey(count(surface.points), [&](const auto& add) {
    for (Index t = 0; t < count(pieces); ++t)
    {
      if (surface.areas[t] > 0)
      {
        add(pieces[t], t);
      }
    }
  });
  std::vector<Detail> result;
  for (Index piece = 0; piece < trianglesOf.size(); ++piece)
  {
    const IndexLists::View triangles = trianglesOf[piece];
    double area = 0;
    for (const Index t : triangles)
    {
      area += surface.areas[t];
    }
    if (area > 0 && isChosen(piece, area))
    {
      const Index step = (triangles.size() + most - 1) / most;
      for (Index i = 0; i < triangles.size(); i += step)
      {
        result.push_back({ middleOf(surface, triangles[i]), area });
      }
    }
  }
  return result;
}

/// The triangles that are chosen, by number.
template <typename Predicate>
std::vector<Detail> chosenTriangles(
  const TriangleSet& surface, const Predicate& isChosen, const Execution& execution)
{
  std::vector<char> chosen(surface.triangles.size(), 0);
  execution.forEach(
    count(chosen), [&](Index t) { chosen[t] = surface.areas[t] > 0 && isChosen(t); });
  double area = 0;
  for (Index t = 0; t < count(chosen); ++t)
  {
    area += chosen[t] ? surface.areas[t] : 0;
  }
  std::vector<Detail> result;
  for (Index t = 0; t < count(chosen); ++t)
  {
    if (chosen[t])
    {
      result.push_back({ middleOf(surface, t), area });
    }
  }
  return result;
}
}

std::vector<Index> pieceOfTriangle(const std::vector<Triangle>& triangles, Index pointCount)
{
  DisjointSets pieces(pointCount);
  for (const Triangle& t : triangles)
  {
    pieces.unite(t[0], t[1]);
    pieces.unite(t[0], t[2]);
  }
  std::vector<Index> result(triangles.size());
  std::transform(triangles.begin(), triangles.end(), result.begin(),
    [&pieces](const Triangle& t) { return pieces.find(t[0]); });
  return result;
}

std::vector<Detail> smallPieces(const TriangleSet& surface, double spacing)
{
  return chosenPieces(surface, pieceOfTriangle(surface.triangles, count(surface.points)),
    [&](Index, double area) { return samplesPerSquare * area < few * spacing * spacing; });
}

std::vector<Detail> barePieces(const TriangleSet& surface, const std::vector<SurfacePoint>& samples)
{
  const std::vector<Index> pieces = pieceOfTriangle(surface.triangles, count(surface.points));
  std::vector<Index> samplesOf(surface.points.size(), 0);
  for (const SurfacePoint& sample : samples)
  {
    ++samplesOf[pieces[sample.triangle]];
  }
  return chosenPieces(surface, pieces, [&](Index piece, double) { return samplesOf[piece] < few; });
}

std::vector<Detail> spikes(const TriangleSet& surface, const std::vector<SurfacePoint>& samples,
  const SpacingField& spacing, const Execution& execution)
{
  constexpr double far = 1.5; // spacings; blue noise leaves hardly a gap of 1.2
  const std::vector<Point> places = positions(samples);
  const Neighbors neighbors(places);
  std::vector<char> isMissed(surface.points.size(), 0);
  execution.forEach(count(isMissed), [&](Index p) {
    const Point& place = surface.points[p];
    isMissed[p] = neighbors.nearestOne(place, far * spacing.at(place)) == None;
  });
  return chosenTriangles(
    surface,
    [&](Index t) {
      const Triangle& corners = surface.triangles[t];
      return std::any_of(corners.begin(), corners.end(), [&](Index p) { return isMissed[p]; });
    },
    execution);
}

std::vector<Detail> hiddenSides(
  const TriangleSet& surface, const std::vector<SurfacePoint>& samples, const Execution& execution)
{
  constexpr double away = -0.5; // cosine: 120 degrees between the normals
  const std::vector<Point> places = positions(samples);
  const Neighbors neighbors(places);
  return chosenTriangles(
    surface,
    [&](Index t) {
      const Index nearest = neighbors.nearestOne(middleOf(surface, t).position);
      return surface.normals[t].dot(samples[nearest].normal) < away;
    },
    execution);
}
}
