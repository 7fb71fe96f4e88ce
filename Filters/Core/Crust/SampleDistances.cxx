// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/SampleDistances.h"

#include "Base/SurfaceTree.h"

#include <algorithm>

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
}

SampleDistances sampleDistances(
  const std::vector<Point>& samples, const CrustSurface& surface, const Execution& execution)
{
  const std::vector<Index> beside = samplesBeside(samples, surface);
  if (beside.empty() || surface.triangles.empty())
  {
    return {};
  }
  const SurfaceTree tree(surface.points, surface.triangles);
  std::vector<double> distances(beside.size());
  execution.forEach(count(beside), [&](Index i) {
    const Point& sample = samples[beside[i]];
    distances[i] = (tree.nearest(sample).point - sample).norm();
  });
  std::sort(distances.begin(), distances.end());
  const std::size_t above = samples.size() / 100; // so many may be farther away
  return { above < distances.size() ? distances[distances.size() - 1 - above] : 0,
    distances.back() };
}
}
