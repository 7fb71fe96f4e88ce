// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BoundarySamples_h
#define medial_BoundarySamples_h

#include "Base/Execution.h"
#include "Base/MoreNeighbors.h"
#include "Samples/ClosedSurface.h"
#include "Samples/LocalThickness.h"
#include "Samples/MissedDetails.h"
#include "Samples/SamplingOptions.h"

#include <memory>
#include <vector>

namespace medial
{
/// Samples of a closed surface that suit its medial axis.
struct BoundarySamples
{
  std::vector<SurfacePoint> points; ///< triangles are those of the surface
  std::vector<double> spacings;     ///< that was asked for at each
  Index mirrored = 0;               ///< so many of them, the first ones, are pairs at sharp edges
  Warnings warnings;                ///< too many are asked for, or walls are too near
};

/// Samples a closed surface, more densely where it is told to.
///
/// Samples are random, evenly spread, and closer together where the solid or a gap is thin, so that
/// opposite walls are several samples apart; in mirrored pairs along sharp edges. Thickness is measured
/// on the surface itself. The same surface gives the same samples. O(n log n) for n samples and triangles.
class BoundarySampler
{
public:
  /// Finds out how far samples may be apart.
  /// @param surface, tree  are referred to
  /// @throw InvalidInput   an option is out of range, or the surface is too narrow for its length to be sampled
  /// @throw Aborted
  BoundarySampler(const ClosedSurface& surface, const SurfaceTree& tree,
    const SamplingOptions& options = {}, const Execution& execution = {});
  ~BoundarySampler();

  /// @throw Aborted
  BoundarySamples samples(const Execution& execution = {}) const;

  /// Halves the spacing at places, for the next samples. Where the places are many, or were
  /// not the first ones, narrow wedges are sampled as densely as other thin places from now on; before, mirrored
  /// pairs were to do.
  /// @throw Aborted
  void refine(const std::vector<Point>& places, const Execution& execution = {});

  /// What the samples that were made miss of the surface: spikes.
  /// @throw Aborted
  std::vector<Detail> spikes(const BoundarySamples& samples, const Execution& execution = {}) const;

  /// What else they may miss, where their balls have another topology: grains, pores, small handles.
  /// @throw Aborted
  std::vector<Detail> hiddenDetails(
    const BoundarySamples& samples, const Execution& execution = {}) const;

  /// Measures the thickness at details, for the next samples.
  /// @return  for how many these will be closer together; 0 for samples with the same spacing everywhere
  /// @throw Aborted
  Index follow(const std::vector<Detail>& details, const Execution& execution = {});

  /// Is a place nearer to a sharp edge than a distance?
  bool isAtSharpEdge(const Point& place, double distance) const;

  /// Adds samples to those that were made: the points of the surface nearest to each place, and on the opposite
  /// side of it, where there is no sample yet.
  /// @param apart    from other samples, in spacings
  /// @param present  finds the samples
  /// @return         how many were added
  Index add(const std::vector<Point>& places, BoundarySamples& samples, double apart,
    const MoreNeighbors& present) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
}

#endif
