// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/CleanScan.h"

#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"
#include "Samples/NoiseEstimate.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

// Steps, each in the frame of the samples: drop outliers, smooth, thin out, estimate normals. Each takes
// O(n log n) time. Smoothing first would move surfaces towards outliers. Samples that were smoothed are too
// close to others in places, and two close samples that differ in height make small balls; so thinning
// comes after it.
namespace medial
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Place = Kernel::Point_3;
using Vector = Kernel::Vector_3;

constexpr Index fewest = 20; ///< for fits of neighbourhoods

/// A jet of degree 2 has six coefficients; three times as many neighbours average noise by half, and reach no
/// farther than two and a half spacings.
constexpr unsigned fitted = 18;

/// Less noise than this, in spacings, is harmless: also clean samples of curved surfaces have some. More calls
/// for one round, since a second one flattens thin parts more than it smooths.
constexpr double cleanNoise = 0.05;

/// Half the distance of nearest neighbours in an even sampling.
constexpr double usualThinning = 0.3;

void require(const CleanOptions& options)
{
  const double factor = options.outlierFactor;
  if (!std::isfinite(factor) || (factor != 0 && factor < 1))
  {
    throw InvalidInput(
      "outliers are at least 1 time as lonely as others (0: none is), not ", factor);
  }
  if (options.smoothingRounds > 100)
  {
    throw InvalidInput("samples are smoothed at most 100 times, not ", options.smoothingRounds);
  }
  if (!std::isfinite(options.thinning) || options.thinning > 1)
  {
    throw InvalidInput(
      "samples are thinned out by at most 1 local spacing, not ", options.thinning);
  }
}

/// Distance of each sample to its sixth nearest other one.
std::vector<double> localSpacings(
  const std::vector<Point>& samples, const Neighbors& neighbors, const Execution& execution)
{
  std::vector<double> result(samples.size());
  execution.forEach(count(samples),
    [&](Index s) { result[s] = (samples[neighbors.nearest(s, 6).back()] - samples[s]).norm(); });
  return result;
}

/// A scan on its way.
struct Draft
{
  std::vector<Point> samples;
  std::vector<Index> ids;

  /// Drops the other samples, and tells how many.
  Index keep(const std::vector<char>& isKept)
  {
    std::size_t next = 0;
    for (std::size_t s = 0; s < isKept.size(); ++s)
    {
      if (isKept[s])
      {
        this->samples[next] = this->samples[s];
        this->ids[next++] = this->ids[s];
      }
    }
    const Index dropped = count(this->samples) - static_cast<Index>(next);
    this->samples.resize(next);
    this->ids.resize(next);
    return dropped;
  }
};

/// Each place once: the lowest sample there.
Draft distinctDraft(const std::vector<Point>& samples, const Frame& frame)
{
  Draft result;
  std::transform(samples.begin(), samples.end(), std::back_inserter(result.samples),
    [&](const Point& p) { return frame.toLocal(p); });
  result.ids.resize(samples.size());
  std::iota(result.ids.begin(), result.ids.end(), 0);
  std::vector<Index> order(result.ids);
  const auto place = [&](Index i) {
    const Point& p = result.samples[i];
    return std::make_tuple(p.x(), p.y(), p.z());
  };
  std::sort(order.begin(), order.end(),
    [&](Index i, Index j) { return std::make_pair(place(i), i) < std::make_pair(place(j), j); });
  std::vector<char> isKept(samples.size(), 1);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    isKept[order[i]] = place(order[i]) != place(order[i - 1]);
  }
  result.keep(isKept);
  return result;
}

/// Drops samples whose local spacing is many times that of their neighbours. Unlike CGAL's remove_outliers,
/// this compares with the neighbours, so that sparse regions stay.
Index dropOutliers(double factor, Draft& draft, const Execution& execution)
{
  const Neighbors neighbors(draft.samples);
  const std::vector<double> spacings = localSpacings(draft.samples, neighbors, execution);
  std::vector<char> isKept(spacings.size());
  execution.forEach(count(isKept), [&](Index s) {
    std::vector<double> around;
    for (const Index n : neighbors.nearest(s, 6))
    {
      around.push_back(spacings[n]);
    }
    isKept[s] = spacings[s] <= factor * median(std::move(around));
  });
  return draft.keep(isKept);
}

double noiseOf(const std::vector<Point>& samples, const Execution& execution)
{
  return noiseEstimate(samples, Neighbors(samples), execution);
}

/// Moves samples onto surfaces fitted to their neighbours.
void smooth(std::vector<Point>& samples)
{
  std::vector<Place> places(samples.size());
  std::transform(samples.begin(), samples.end(), places.begin(),
    [](const Point& p) { return Place(p.x(), p.y(), p.z()); });
  CGAL::jet_smooth_point_set<CGAL::Sequential_tag>(places, fitted);
  std::transform(places.begin(), places.end(), samples.begin(),
    [](const Place& p) { return Point(p.x(), p.y(), p.z()); });
}

/// Drops samples near to a lower one that stays.
Index thinOut(double factor, Draft& draft, const Execution& execution)
{
  const Neighbors neighbors(draft.samples);
  const std::vector<double> spacings = localSpacings(draft.samples, neighbors, execution);
  std::vector<char> isKept(spacings.size(), 1);
  for (Index s = 0; s < count(spacings); ++s)
  {
    for (const Index n :
      isKept[s] ? neighbors.within(s, factor * spacings[s]) : std::vector<Index>())
    {
      isKept[n] = isKept[n] && n <= s;
    }
  }
  return draft.keep(isKept);
}

/// Normals with a common orientation; zero where none was found.
std::vector<Point> estimatedNormals(const std::vector<Point>& samples)
{
  using Oriented = std::tuple<Place, Vector, Index>; // its normal, its number
  std::vector<Oriented> oriented;
  oriented.reserve(samples.size());
  for (const Point& p : samples)
  {
    oriented.emplace_back(Place(p.x(), p.y(), p.z()), Vector(0, 0, 0), count(oriented));
  }
  const auto parameters =
    CGAL::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Oriented>())
      .normal_map(CGAL::Nth_of_tuple_property_map<1, Oriented>());
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(oriented, fitted, parameters);
  const auto end = CGAL::mst_orient_normals(oriented, fitted, parameters);
  std::vector<Point> result(samples.size(), Point::Zero());
  std::for_each(oriented.begin(), end, [&](const Oriented& sample) {
    const Vector& normal = std::get<1>(sample);
    result[std::get<2>(sample)] = Point(normal.x(), normal.y(), normal.z());
  });
  return result;
}

void requireEnough(const Draft& draft, const char* which)
{
  if (count(draft.samples) < fewest)
  {
    throw InvalidInput("there are only ", draft.samples.size(), " ", which,
      " samples; cleaning needs at least ", fewest);
  }
}
}

CleanScan cleanScan(
  const std::vector<Point>& samples, const CleanOptions& options, const Execution& execution)
{
  require(options);
  const Frame frame = frameOf(samples);
  Draft draft = distinctDraft(samples, frame);
  requireEnough(draft, "distinct");
  CleanScan result;
  if (options.outlierFactor > 0)
  {
    result.outliers = dropOutliers(options.outlierFactor, draft, execution.between(0, 0.1));
    requireEnough(draft, "remaining");
  }
  result.noiseBefore = noiseOf(draft.samples, execution.between(0.1, 0.2));
  const bool isNoisy = result.noiseBefore >= cleanNoise;
  result.smoothingRounds = options.smoothingRounds < 0 ? isNoisy : options.smoothingRounds;
  for (Index round = 0; round < result.smoothingRounds; ++round)
  {
    execution.report(0.2 + 0.4 * round / result.smoothingRounds);
    smooth(draft.samples);
  }
  result.thinning = options.thinning >= 0 ? options.thinning : isNoisy ? usualThinning : 0;
  if (result.thinning > 0)
  {
    result.thinned = thinOut(result.thinning, draft, execution.between(0.6, 0.7));
  }
  result.noiseAfter = noiseOf(draft.samples, execution.between(0.7, 0.8));
  if (options.estimateNormals)
  {
    result.normals = estimatedNormals(draft.samples);
  }
  std::transform(draft.samples.begin(), draft.samples.end(), std::back_inserter(result.samples),
    [&](const Point& p) { return frame.toWorld(p); });
  result.ids = std::move(draft.ids);
  execution.report(1);
  return result;
}
}
