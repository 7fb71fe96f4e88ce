// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/SampleDistances.h"

#include "Base/Lists.h"
#include "Base/Neighbors.h"
#include "Base/Polygons.h"
#include "Base/SurfaceTree.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// The samples that are no point of the surface.
std::vector<Index> samplesBeside(const std::vector<Point>& samples, const CrustSurface& surface)
{
  std::vector<char> isPoint(samples.size(), 0);
  for (const Index sample : surface.sampleOfPoint)
  {
    if (sample != None)
    {
      isPoint[sample] = 1;
    }
  }
  std::vector<Index> result;
  for (Index s = 0; s < count(samples); ++s)
  {
    if (!isPoint[s])
    {
      result.push_back(s);
    }
  }
  return result;
}

/// Finds the triangles near places.
class NearTriangles
{
public:
  explicit NearTriangles(const CrustSurface& crustSurface)
    : surface(crustSurface)
    , points(crustSurface.points)
    , trianglesAt(trianglesAtPoints(crustSurface.triangles, count(crustSurface.points)))
  {
  }

  /// The distance to the triangles at the nearest points.
  double distance(const Point& place) const
  {
    constexpr Index howMany = 3;
    double least = std::numeric_limits<double>::infinity();
    for (const Index p : this->points.nearest(place, howMany))
    {
      for (const Index t : this->trianglesAt[p])
      {
        const auto& [a, b, c] = this->surface.triangles[t];
        least = std::min(least,
          distanceToTriangle(
            place, this->surface.points[a], this->surface.points[b], this->surface.points[c]));
      }
    }
    return least;
  }

private:
  const CrustSurface& surface;
  Neighbors points;
  IndexLists trianglesAt;
};
}

SampleDistances sampleDistances(
  const std::vector<Point>& samples, const CrustSurface& surface, const Execution& execution)
{
  const std::vector<Index> beside = samplesBeside(samples, surface);
  if (beside.empty() || surface.triangles.empty())
  {
    return {};
  }
  const NearTriangles near(surface);
  std::vector<double> distances(beside.size());
  execution.forEach(
    count(beside), [&](Index i) { distances[i] = near.distance(samples[beside[i]]); });
  std::sort(distances.begin(), distances.end());
  const std::size_t above = samples.size() / 100; // so many may be farther away
  return { above < distances.size() ? distances[distances.size() - 1 - above] : 0,
    distances.back() };
}
}
