// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PolarBalls_h
#define medial_PolarBalls_h

#include "Balls/DistinctSamples.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/SurfaceTree.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <vector>

namespace medial
{
/// The polar balls of a set of samples, and the dual of their power diagram (paper 2; [ACK01]): what
/// later stages read.
///
/// A polar ball is centred at a pole: a farthest Voronoi vertex of a sample's cell, inside or
/// outside the solid. One ball stands for all Delaunay cells with the same circumsphere, as far as the
/// samples' precision tells; its samples are on its sphere up to that (DistinctSamples::precision, at
/// most leastPrecision spacings). Lengths are in the unit of the samples, volumes in its cube.
struct PolarBalls
{
  // One entry for each sample, in the order of the input.
  std::vector<Point> samples;
  // A sample whose pole is in a crowd is near to its ball, but not on it; see standingPoles().
  std::vector<Index> innerBall; ///< its ball inside the solid, or None
  std::vector<Index> outerBall; ///< its ball outside the solid, or None
  /// Of the surface there, outwards, of length 1, or 0 where it has none or counts as another sample; empty where
  /// samples came without normals.
  std::vector<Point> normals;

  // One entry for each ball.
  std::vector<Ball> balls;
  std::vector<Side> sides;
  std::vector<char> touchesGuard; ///< passes through a corner of the cube around the samples
  std::vector<double> volumes;    ///< of the Delaunay cells that count for it; 0 where not inner
  std::vector<double>
    poleVolumes;          ///< of only the cells for whose circumsphere it stands (paper 4.2)
  IndexLists ballSamples; ///< all samples on its sphere, ascending

  double spacing = 0; ///< mean distance of a distinct sample to the nearest other one

  Tetrahedra triangulation; ///< the regular one of the balls (weights: squared radii)
};

/// What is known about the samples that no later stage reads: one entry for each sample, in the order
/// of the input.
struct SampleDescription
{
  std::vector<Index>
    duplicateOf;               ///< the sample that it counts as, at the very same place or within
                               ///< the tolerance of it; None where it counts itself
  std::vector<double> quality; ///< -cos of the angle at which it sees its two poles, -1 ... 1: 1 is
                               ///< best; 0 and less: an edge, or too few samples
  double mergeTolerance = 0;   ///< that was used, in the unit of the samples
  Warnings warnings;           ///< about the samples and the balls
};

struct PolarBallsAndSamples
{
  PolarBalls balls;
  SampleDescription samples;
  Betti powerShape; ///< Betti numbers of the balls' power shape, which are those of the solid
};

/// The regular triangulation of balls in one frame, each jittered by its number: the dual of their power diagram.
/// @throw Aborted
Tetrahedra powerCells(const std::vector<Ball>& balls, const Execution& execution = {});

/// The polar balls of `samples`, each labelled inner or outer, and a description of the samples.
///
/// @param samples  points of the boundary of a solid, any unit; repeated points count once
/// @param options  which points count as repeated
/// @param solid    the surface of the solid, if it is known: then it tells the sides, and nothing is
///                 doubted: the power shape's Betti numbers are to be compared with its own. Closed
/// @param normals  of the surface at each sample, outwards, of any length; then they tell the sides, where
///                 the solid doesn't, see normalVotes(). Kept unless they contradict each other. Empty: there are none
/// @throw InvalidInput  fewer than 4 distinct points, all on a line or in a plane, or a coordinate
///                      or an option that is not finite; another number of normals than samples
/// @throw Aborted
PolarBallsAndSamples polarBallsAndSamples(const std::vector<Point>& samples,
  const MergeOptions& options = {}, const Execution& execution = {},
  const SurfaceTree* solid = nullptr, const std::vector<Point>& normals = {});

/// The polar balls and their samples only: no sides, no volumes, no triangulation.
/// @param samples  not all in a plane
/// @throw Aborted
PolarBalls ballsWithoutSides(const std::vector<Point>& samples, const Execution& execution = {});

/// The polar balls alone.
PolarBalls polarBalls(const std::vector<Point>& samples, const Execution& execution = {});

/// For each sample the inner balls that it lies on, ascending.
std::vector<std::vector<Index>> innerBallsOfSamples(const PolarBalls& polarBalls);
}

#endif
