// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Measures_h
#define medial_Measures_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"

#include <string>
#include <vector>

/// What makes a part significant.
///
/// To add a measure: a number in `Measure` and a row with its formula in the table of Measures.cxx; and
/// the same number in vtkMedialPrune::MeasureType. Schedules, columns of the table of parts, cell
/// arrays, the help of the program and the drop-down in ParaView follow from the table.
namespace medial
{
/// The first two are the paper's (4.2). The numbers are in files: they never change.
enum class Measure
{
  /// Number of triangles, lines or vertices of the part.
  TriangleCount = 0,

  /// Volume of the Delaunay cells that count for the part's balls / the same of all balls. Each inner
  /// cell counts for one ball. Parts that meet at a ball share it in proportion to their areas, see
  /// ballShares(), so that the values of all parts sum to 1.
  RelativeVolume = 1,

  /// The same for the Delaunay cells on the poles at the part's points alone, as the paper says
  /// literally. A pole that several parts share counts in each, so that the values do not sum to 1.
  RelativePoleVolume = 2,

  /// Area of its triangles; 0 for lines and vertices, which no threshold removes.
  Area = 3,

  /// Mean and maximum radius of the maximal balls at its points, each point once.
  MeanRadius = 4,
  MaximumRadius = 5,

  /// Mean over its cells, weighted by area or length, of the largest angle at which the cell sees two
  /// of its sites (see SiteView.h). Small where a part only follows noise, 180 in the middle of a plate.
  ObjectAngle = 6,

  /// Largest distance of two sites of one of its cells ([CL05]). Up to this length the part is near the
  /// surface everywhere.
  Lambda = 7,

  /// Largest erosion thickness of its cells ([YSC16], see Erosion.h), of the axis before pruning.
  ErosionThickness = 8,

  /// How far the union of the polar balls on the axis recedes, at most, where the part goes: the
  /// largest, over the balls that only this part holds, of the least, over the other balls, of
  /// distance + radius - other radius, if above 0. Exact where one ball covers best, else an upper
  /// bound. The diagonal of the balls' bounding box for a part that holds all balls.
  HausdorffDistance = 9,

  /// Length of the part's free border: of its edges that are in one triangle of the axis. 0 for lines
  /// and vertices, and for a part that is not at the border.
  BoundaryLength = 10
};

/// What a measure counts, and with it how its thresholds are written in a schedule.
enum class Unit
{
  Count,  ///< whole number of cells: t5
  Share,  ///< of the solid's volume, 0 ... 1; in per cent: v1%
  Length, ///< in the samples' unit, their mean spacings, or per cent of the diagonal of their bounding box: r0.5, r1s, r2%
  Area,   ///< in the square of the samples' unit, or of their mean spacing: a0.5, a2s
  Degrees ///< 0 ... 180: o20
};

/// A row of the table of measures: all there is to know about one.
struct MeasureTraits
{
  Measure measure;
  const char* name;      ///< also its column in the table of parts
  const char* cellArray; ///< of the cells of the parts
  char letter;           ///< of its words in a schedule
  Unit unit;
  bool addsUp; ///< the value of several parts together is the sum of theirs; else the largest
  bool tellsOfCurves; ///< else it is 0 for parts without triangles, and no threshold removes them
  const char* reference;   ///< where the formula is from, see the bibliography
  const char* description; ///< in a few words
  /// For each part of a partition its value, never negative.
  std::vector<double> (*formula)(const class PartMeasures&, const Partition&, const Execution&);
};

/// All measures, in the order of their numbers.
const std::vector<MeasureTraits>& allMeasures();

const MeasureTraits& traitsOf(Measure measure);

/// @return  nullptr where there is no such measure
const MeasureTraits* findMeasure(int number);
const MeasureTraits* findMeasure(const std::string& name);

/// The words for a unit: count, share of the volume, length, area, degrees.
const char* unitName(Unit unit);

/// No part has a value of a measure with this unit above this, so a larger threshold is a mistake: 1 for
/// a share, 180 for degrees, else the largest number.
double largestThreshold(Unit unit);

/// That there is no such measure, and which there are.
std::string noMeasure(const std::string& measure);

/// The value of two parts together.
double together(Measure measure, double a, double b);

/// What the measures need to know of an axis. It does not depend on the partition, so that it is found
/// once and used for many partitions.
class PartMeasures
{
public:
  /// @param medialAxis, cells  of the axis; must outlive this. Which cells live doesn't matter.
  PartMeasures(const MedialAxis& medialAxis, const LivingCells& cells);

  const MedialAxis& axis;
  const AxisEdges& edges;
  const IndexLists& cellsOfPoint;
  const double solidVolume;        ///< of all balls
  const std::vector<double> sizes; ///< of each cell: area, length, 1

  /// For each part of a partition of the axis' cells its value, never negative.
  std::vector<double> significance(
    Measure measure, const Partition& partition, const Execution& execution = {}) const;
};
}

#endif
