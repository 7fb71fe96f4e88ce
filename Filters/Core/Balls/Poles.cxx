// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/Poles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <functional>

namespace medial
{
namespace
{
/// Calls body(sample, class) for all classes of cells at each sample.
template <typename Body>
void forClassesAtSamples(const DelaunaySpheres& spheres, const Body& body)
{
  for (Index c = 0; c < count(spheres.delaunay.cells); ++c)
  {
    for (const Index s : spheres.delaunay.cells[c])
    {
      if (s < spheres.sampleCount)
      {
        body(s, spheres.classOfCell[c]);
      }
    }
  }
}

/// The classes as far as the farthest one around each sample, up to the precision of samples, of those
/// that a condition allows. Where the samples are regular, there are several. Rounding would choose one
/// of them in each place, so all of them are poles.
/// @return  the lowest of them for each sample, or None
template <typename Condition>
std::vector<Index> farthestClasses(
  const DelaunaySpheres& spheres, const Condition& isAllowed, std::vector<char>& isPole)
{
  // Every sphere passes through its sample, so the farthest centre has the largest radius.
  std::vector<double> largest(spheres.sampleCount, -1);
  forClassesAtSamples(spheres, [&](Index s, Index c) {
    if (spheres.ballOfCell[c].radius > largest[s] && isAllowed(s, c))
    {
      largest[s] = spheres.ballOfCell[c].radius;
    }
  });
  std::vector<Index> result(spheres.sampleCount, None);
  forClassesAtSamples(spheres, [&](Index s, Index c) {
    if (spheres.ballOfCell[c].radius >= largest[s] - spheres.precision && isAllowed(s, c))
    {
      result[s] = result[s] == None ? c : std::min(result[s], c);
      isPole[c] = 1;
    }
  });
  return result;
}

/// Normals of triangles are known up to this: samples up to a thousandth of their distance, and triangles
/// may be thin.
constexpr double normalError = 0.01;

/// The outward normal of a cell's three samples, where the fourth corner is a guard, or else zero.
/// Spheres that touch a guard stand for half-spaces.
std::vector<Point> hullNormals(const DelaunaySpheres& spheres)
{
  std::vector<Point> result(spheres.delaunay.cells.size(), Point::Zero());
  for (Index c = 0; c < count(result); ++c)
  {
    const Tetrahedron& corners = spheres.delaunay.cells[c];
    const auto isGuard = [&](Index v) { return v >= spheres.sampleCount; };
    if (std::count_if(corners.begin(), corners.end(), isGuard) != 1)
    {
      continue;
    }
    const auto guard = std::find_if(corners.begin(), corners.end(), isGuard);
    const Triangle triangle = facet(corners, static_cast<int>(guard - corners.begin()));
    const Point& p = spheres.points[triangle[0]];
    const Point normal =
      (spheres.points[triangle[1]] - p).cross(spheres.points[triangle[2]] - p).normalized();
    result[c] = normal.dot(spheres.points[*guard] - p) > 0 ? normal : Point(-normal);
  }
  return result;
}

/// The normals that are different.
std::vector<Point> faceNormals(const std::vector<Point>& normals)
{
  std::vector<Point> faces;
  for (const Point& normal : normals)
  {
    const auto isSame = [&](const Point& face) { return (face - normal).norm() < normalError; };
    if (std::none_of(faces.begin(), faces.end(), isSame))
    {
      faces.push_back(normal);
    }
  }
  return faces;
}

/// Do hull triangles with these normals form two or three flat faces at a right angle? Around a sample of
/// a rounded edge, or a lone one off the surface, each triangle has a normal of its own.
bool areOfSharpEdge(const std::vector<Point>& normals)
{
  const std::vector<Point> faces = faceNormals(normals);
  return faces.size() <= 3 && std::any_of(faces.begin(), faces.end(), [&](const Point& u) {
    return std::any_of(
      faces.begin(), faces.end(), [&](const Point& v) { return u.dot(v) < normalError; });
  });
}

/// The samples but those on sharp convex edges of flat faces. The half-spaces in front of them are all
/// equally far. So the farthest Voronoi vertices there are all outside, and any inside is as near as the
/// next sample.
std::vector<char> offEdges(const DelaunaySpheres& spheres)
{
  const std::vector<Point> normals = hullNormals(spheres);
  std::vector<std::vector<Point>> ofSample(spheres.sampleCount);
  for (Index c = 0; c < count(normals); ++c)
  {
    for (const Index v : spheres.delaunay.cells[c])
    {
      if (v < spheres.sampleCount && !normals[c].isZero())
      {
        ofSample[v].push_back(normals[c]);
      }
    }
  }
  std::vector<char> result(spheres.sampleCount);
  std::transform(ofSample.begin(), ofSample.end(), result.begin(), std::not_fn(areOfSharpEdge));
  return result;
}

/// For each cell: does its class touch a guard?
std::vector<char> guardedCells(const DelaunaySpheres& spheres)
{
  std::vector<char> classes(spheres.classOfCell.size(), 0);
  for (Index c = 0; c < count(classes); ++c)
  {
    const Tetrahedron& corners = spheres.delaunay.cells[c];
    classes[spheres.classOfCell[c]] |= std::any_of(
      corners.begin(), corners.end(), [&](Index v) { return v >= spheres.sampleCount; });
  }
  std::vector<char> result(classes.size());
  std::transform(spheres.classOfCell.begin(), spheres.classOfCell.end(), result.begin(),
    [&](Index c) { return classes[c]; });
  return result;
}

/// Gives samples on sharp edges second poles outside: all half-spaces at a right angle to the first pole.
void addPolesOfEdges(
  const DelaunaySpheres& spheres, const std::vector<char>& isOffEdge, Poles& result)
{
  const double rightAngle = 0.1; // guards are not infinitely far away, but 2.5 diagonals
  const std::vector<char> isGuarded = guardedCells(spheres);
  forClassesAtSamples(spheres, [&](Index s, Index c) {
    auto& [first, second] = result.ofSample[s];
    const Point& sample = spheres.points[s];
    if (!isOffEdge[s] && isGuarded[c] &&
      opposition(sample, spheres.ballOfCell[first], spheres.ballOfCell[c]) > -rightAngle)
    {
      second = second == None ? c : std::min(second, c);
      result.isPole[c] = 1;
    }
  });
}
}

Poles poles(const DelaunaySpheres& spheres)
{
  Poles result{ {}, std::vector<char>(spheres.classOfCell.size(), 0) };
  const auto isAny = [](Index, Index) { return true; };
  const std::vector<Index> first = farthestClasses(spheres, isAny, result.isPole);
  const std::vector<char> isOffEdge = offEdges(spheres);
  const auto isOpposite = [&](Index s, Index c) {
    const Point& sample = spheres.points[s];
    const Point u = (spheres.ballOfCell[first[s]].center - sample).normalized();
    // At a right angle rounding of the samples tells nothing.
    return isOffEdge[s] && u.dot(spheres.ballOfCell[c].center - sample) < -spheres.precision;
  };
  const std::vector<Index> second = farthestClasses(spheres, isOpposite, result.isPole);
  for (Index s = 0; s < spheres.sampleCount; ++s)
  {
    result.ofSample.push_back({ first[s], second[s] });
  }
  addPolesOfEdges(spheres, isOffEdge, result);
  return result;
}
}
