// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Centerlines_h
#define medial_Centerlines_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Measuring/Centerline.h"

#include <vector>

namespace medial
{
/// Where centerlines meet or end.
struct CenterlineNode
{
  Point point;
  double radius;
  Index degree;   ///< so many ends of centerlines are here
  bool isAtPlate; ///< the rod goes on as a plate
};

struct Centerlines
{
  std::vector<Centerline> branches; ///< their ends are numbers of nodes
  std::vector<CenterlineNode> nodes;
  Index openedVoids; ///< see CurveSkeleton; plates, so they matter with curves on plates only
};

struct CenterlineOptions
{
  /// A sheet of the axis up to so many times as wide as thick is a rod; 0: curves run through plates,
  /// too. Then they are connected as the axis is, and have its loops.
  double widthRatio = 1.5;
};

/// Lines along the middle of rods and tubes, from node to node. A tube is a rod here: its inside is the
/// solid.
///
/// The axis of a rod is a narrow sheet, or many, with lines between. It is collapsed to a graph
/// (CurveSkeleton), whose twigs go (Twigs), whose near forks become one (CurveBranches), whose lines are
/// smoothed (CurveSmoothing) and meet in points (CurveForks); and cut where plates begin (RodPieces). All
/// but the cuts keep the number of pieces and of loops.
///
/// Branches are in the order of the lowest points of the axis at their ends, then loops that meet nothing.
/// Pieces whose axis is a single point, such as a ball, have none. Takes O(n log n).
///
/// @throw InvalidInput  a ratio that is negative or no number, or no erosion thickness
/// @throw Aborted
Centerlines centerlines(
  const MedialAxis& axis, const CenterlineOptions& options = {}, const Execution& execution = {});
}

#endif
