// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Measures_h
#define medial_Measures_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/Partition.h"

#include <string>
#include <vector>

namespace medial
{
/// What makes a part significant. The first two are the paper's (4.2); the numbers are in files.
enum class Measure
{
  TriangleCount = 0,  ///< number of triangles, lines or vertices
  RelativeVolume = 1, ///< volume of its balls' Delaunay cells / volume of the solid, 0 ... 1
  PoleVolume = 2,     ///< the same of the poles at its points alone, shared ones in every part
  Area = 3,           ///< of its triangles; 0 for lines and vertices
  MeanRadius = 4,     ///< of the maximal balls at its points, each point once
  MaximumRadius = 5,  ///< of the maximal balls at its points
  ObjectAngle = 6,    ///< mean over its cells, by area or length; 0 ... 180 degrees
  Lambda = 7, ///< largest of its cells; the lambda axis ([CL05]) has the points above a value
  ErosionThickness = 8, ///< largest of its cells, of the axis before pruning ([YSC16])
  /// How far, at most, the union of the polar balls on the axis recedes where the part goes: the
  /// largest, over the balls that only this part holds, of the least, over the others, of distance +
  /// radius - other radius, if above 0. Exact where one ball covers best, else an upper bound. The
  /// diagonal of their bounding box for a part that holds them all.
  HausdorffDistance = 9
};

/// How a measure behaves, and what it is called.
struct MeasureTraits
{
  Measure measure;
  const char* name; ///< column of the table of parts
  const char* unit; ///< 1, length, area, degrees
  bool addsUp;      ///< the value of several parts is (at most) the sum of theirs; else the largest
};

/// All measures in the order of their numbers.
const std::vector<MeasureTraits>& allMeasures();

/// @return  nullptr where there is no such measure
const MeasureTraits* findMeasure(int number);
const MeasureTraits* findMeasure(const std::string& name);

/// All names, with commas between.
std::string measureNames();

/// The value of two parts together.
double together(Measure measure, double a, double b);

/// The significance of the parts of an axis, again and again for other partitions. What doesn't
/// depend on the partition is found once.
class PartMeasures
{
public:
  /// @param axis, cellsOfPoint  of the axis; must outlive this
  PartMeasures(const MedialAxis& axis, const IndexLists& cellsOfPoint);

  const MedialAxis& axis;
  const double solidVolume;        ///< of all balls
  const std::vector<double> sizes; ///< of each cell: area, length, 1

  /// For each part of a partition of the axis' cells its value, never negative.
  std::vector<double> significance(
    Measure measure, const Partition& partition, const Execution& execution = {}) const;

private:
  std::vector<double> ofVolumes(const Partition& partition) const;
  std::vector<double> poleVolumes(const Partition& partition) const;
  std::vector<double> objectAngles(const Partition& partition) const;
  std::vector<double> hausdorffDistances(
    const Partition& partition, const Execution& execution) const;

  const IndexLists& cellsOfPoint;
};
}

#endif
