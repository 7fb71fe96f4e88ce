// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MedialParts_h
#define medial_MedialParts_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Parts/ContactCurves.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Parts/Necks.h"
#include "Parts/Partition.h"

#include <vector>

namespace medial
{
/// A part of the axis (paper 4.1): a connected group of triangles, grown over edges with exactly two
/// triangles; or one dangling chain of edges; or a single vertex.
struct MedialPart
{
  int dimension;        ///< 2: triangles, 1: edges, 0: a vertex
  int level;            ///< 1 at the border of the axis, +1 inwards; 0: closed sheet, never reached
  double volume;        ///< of its shares of its balls' Delaunay cells, cube of the samples' unit
  double minimumRadius; ///< of the maximal balls at its points
  Index contacts;       ///< number of contact curves it has a share in
  Index neighbors;      ///< number of parts that it shares a contact with
  double neckRatio;     ///< of its body, see Necks.h; 1 where it was not cut off at a neck
  bool onLoop; ///< TopologyGraph::partOnLoop: it joins contacts that are connected without it;
               ///< a loop within one part doesn't count
  Point lower, upper; ///< corners of its bounding box
  Point centroid;     ///< of its triangles by area, of its edges by length
  /// The sides, descending, of the box with the moments of inertia of its triangles or edges: a
  /// rectangle has its own two and 0.
  Point principalLengths;
};

struct MedialParts
{
  std::vector<Index> partOfCell; ///< numbering of AxisCells
  std::vector<MedialPart> parts; ///< by lowest triangle; then edges; then vertices
  /// For each measure by its number the value of each part, as PartMeasures::significance. But the
  /// relative volumes are relative to these parts: they sum to 1 after pruning, too.
  std::vector<std::vector<double>> values;
  std::vector<double> suggestedThresholds; ///< for each measure by its number, see Thresholds.h
  std::vector<ContactCurve> contacts;      ///< see ContactCurves.h

  double value(Measure measure, Index part) const
  {
    return this->values[static_cast<int>(measure)][part];
  }
};

/// The parts of an axis, their levels and measures. Every ball counts for one part, so that the relative
/// volumes sum to 1.
/// @param maximumLevel  parts above it get level 0; 0 or less: no limit
/// @param neckRatio     parts are also cut at necks, see Necks.h; 0: they aren't
MedialParts decompose(const MedialAxis& axis, int maximumLevel = 0, const Execution& execution = {},
  double neckRatio = 0);

/// The same for the living cells of an axis alone; the others are in no part.
/// @param partition  of these cells
/// @param measures   of this axis
/// @param bodies     which no part crosses; empty: there is one body
MedialParts decompose(const LivingCells& living, const Partition& partition,
  const PartMeasures& measures, const Execution& execution = {}, const Bodies& bodies = {});
}

#endif
