// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MedialParts_h
#define medial_MedialParts_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Parts/Necks.h"
#include "Parts/Partition.h"

#include <vector>

namespace medial
{
/// A connected group of triangles, grown over edges with exactly two triangles; or one dangling
/// chain of edges; or a single vertex (paper 4.1).
struct MedialPart
{
  int dimension;   ///< 2: triangles, 1: edges, 0: a vertex
  int level;       ///< 1 at the border of the axis, +1 inwards; 0: closed sheet, never reached
  Index triangles; ///< how many
  double area;     ///< of its triangles, square of the samples' unit
  double volume;   ///< of the Delaunay cells whose ball is this part's, cube of the unit
  double relativeVolume;                           ///< volume / sum over all parts
  double meanRadius, minimumRadius, maximumRadius; ///< over its points
  /// The measures of these names, see Measures.h.
  double poleVolume, objectAngle, lambda, erosionThickness, hausdorffDistance;
  Index contacts;   ///< number of contact curves it has a share in
  Index neighbors;  ///< number of parts that it shares a contact with
  double neckRatio; ///< of its body, see Necks.h; 1 where it was not cut off at a neck
  bool onLoop;      ///< TopologyGraph::partOnLoop: it joins contacts that hang together without it;
                    ///< a loop within one part doesn't count
  Point lower, upper; ///< corners of its bounding box
  Point centroid;     ///< of its triangles by area, of its edges by length
  /// The sides, descending, of the box with the moments of inertia of its triangles or edges: a
  /// rectangle has its own and 0.
  Point principalLengths;
};

/// An unbroken polyline shared by touching parts (paper 4.3); or a point where a part touches others
/// but has no share in a polyline.
struct ContactCurve
{
  std::vector<Index> points; ///< medial points in order; first == last where it is closed
  std::vector<Index> parts;  ///< the parts that touch along it, ascending
};

struct MedialParts
{
  std::vector<Index> partOfCell;           ///< numbering of AxisCells
  std::vector<MedialPart> parts;           ///< by lowest triangle; then edges; then vertices
  std::vector<double> suggestedThresholds; ///< for each measure by its number, see Thresholds.h
  std::vector<ContactCurve> contacts;      ///< polylines by lowest edge, then points, ascending
};

/// The parts of an axis and their levels.
///
/// Every ball is counted in one part, so the relative volumes sum to 1.
/// @param maximumLevel  parts above it get level 0; 0 or less: no limit
/// @param neckRatio     parts are cut at necks, too, see Necks.h; 0: they aren't
MedialParts decompose(const MedialAxis& axis, int maximumLevel = 0, const Execution& execution = {},
  double neckRatio = 0);

/// The same of the living cells of an axis alone; the others are in no part.
/// @param partition  of these cells
/// @param measures   of this axis
/// @param bodies     that bound the parts; none: nothing does
MedialParts decompose(const LivingCells& living, const Partition& partition,
  const PartMeasures& measures, const Execution& execution = {}, const Bodies& bodies = {});

/// The contact curves and points of the living parts, see MedialParts.
std::vector<ContactCurve> contacts(const LivingCells& living, const Partition& partition);

/// For each polar ball the part that it counts for: of the parts with most of the cells at its
/// medial point the first; a ball off the axis follows its owner. None where its owner is gone.
std::vector<Index> partOfBall(const MedialAxis& axis, const std::vector<Index>& partOfCell);

/// The same, where the cells of each point are known.
std::vector<Index> partOfBall(
  const MedialAxis& axis, const std::vector<Index>& partOfCell, const IndexLists& cellsOfPoint);

/// For each polar ball: does it or its owner lie on a point that a cell of the axis uses? After
/// pruning these are the balls that make the surface (paper 5).
std::vector<char> keptBalls(const MedialAxis& axis);

/// The same where only the living cells of the axis count.
std::vector<char> keptBalls(const MedialAxis& axis, const LivingCells& living);
}

#endif
