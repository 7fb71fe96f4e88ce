// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CleanScan_h
#define medial_CleanScan_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What is cleaned, in local spacings. The local spacing of a sample is its distance to its sixth nearest other
/// one. Negative values are found from the samples.
struct CleanOptions
{
  double outlierFactor =
    3; ///< samples this much lonelier than their neighbours are dropped; 0: none
  Index smoothingRounds = -1; ///< how often samples are moved onto fitted surfaces; 0: never
  double thinning = -1; ///< samples nearer than this to another one are dropped, at most 1; 0: none
  bool estimateNormals = false; ///< of the surface at the samples, outwards
};

struct CleanScan
{
  std::vector<Point> samples; ///< in the unit of the input, in its order
  std::vector<Point> normals; ///< for each sample, where they were asked for; zero where not known
  std::vector<Index> ids;     ///< for each sample the point of the input that it was

  // What was done.
  double noiseBefore = 0;    ///< noiseEstimate() of the input without outliers, in spacings
  double noiseAfter = 0;     ///< of the samples
  Index outliers = 0;        ///< samples dropped because they are lonely
  Index thinned = 0;         ///< samples dropped because they are close to others
  Index smoothingRounds = 0; ///< rounds made
  double thinning = 0;       ///< that was used, in local spacings
};

/// Samples of a scan, as polar balls need them: drops lonely ones, moves the others onto surfaces fitted to
/// their neighbours (CGAL's jet_smooth_point_set) as often as their noise needs, drops those that came too
/// close to each other, and estimates normals (CGAL's jet_estimate_normals and mst_orient_normals).
///
/// Clean samples stay where they are. Where solid or gap are thinner than about five spacings, both sides are
/// neighbours, so that smoothing may join them.
///
/// @throw InvalidInput  less than 20 distinct samples; a coordinate or an option that is not finite or not
///                      in its range
/// @throw Aborted
CleanScan cleanScan(const std::vector<Point>& samples, const CleanOptions& options = {},
  const Execution& execution = {});
}

#endif
