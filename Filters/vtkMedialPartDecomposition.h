// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMedialPartDecomposition
 * @brief   the parts of a medial axis, their levels, and the curves where they touch
 *
 * Third filter of the medial axis pipeline. A part is a connected group of triangles, grown over
 * edges with exactly two triangles; or a chain of lines; or a vertex. Parts are numbered by their
 * lowest triangle, then lines, then vertices.
 *
 * Input: vtkPolyData, the output of vtkMedialAxis or vtkMedialPrune.
 *
 * Output 0: vtkPolyData, the input with more arrays.
 *
 * Cell data
 *  - `PartId` (vtkIdType, >= 0): the cell's part.
 *  - `PartRank` (vtkIdType, >= 0, active scalars): its part's rank, by which parts are coloured. The part
 *    with the largest volume has rank 0, the next 1, and so on. Where the input has ranks, as that of
 *    vtkMedialPrune, a part takes over the lowest of its cells': it keeps the rank that it had before pruning.
 *  - `PartLevel` (int): of its part. 1 at the border of the axis, one more for each step inwards; 0
 *    for closed sheets that no border reaches, and above MaximumLevel.
 *  - An array for each measure of its part (vtkIdType for counts, else double). Its name is
 *    vtkMedialPrune::GetMeasureArray: `TriangleCount`, `RelativeVolume`, `RelativePoleVolume`, and `Part`
 *    with the measure's name for the others, such as `PartArea`. See vtkMedialPrune::MeasureType.
 *
 * Field data: `NumberOfParts` (vtkIdType, 1 value); `SuggestedThreshold` (double, 1 tuple with a
 * component for each vtkMedialPrune::MeasureType): a threshold in the widest gap between the values of
 * the parts of level 1. It removes at least half of them and at most a tenth of the volume; 0 if there
 * is no such gap.
 *
 * Output 1: vtkTable, one row for each part
 *  - A column for each measure by its name (vtkMedialPrune::GetMeasureName), with the same values as the
 *    cell arrays. The relative volumes sum to 1; to 0 where pruning has left no ball.
 *  - `PartId`, `PartRank`, `Contacts` (number of contact curves), `Neighbors` (number of parts that it shares a
 *    contact with) (vtkIdType).
 *  - `Dimension` (2 triangles, 1 lines, 0 a vertex), `Level` (int).
 *  - `Volume` (double, cube of the samples' unit): of the Delaunay cells that count for its balls.
 *  - `MinimumRadius` (double): of the maximal balls at its points.
 *  - `NeckRatio` (double, 0 ... 1): if it was cut off at a neck, its limb's largest radius / that of
 *    what it was cut off; else 1.
 *  - `OnLoop` (unsigned char): 1 if the part joins contacts that are connected without it, as in
 *    output 3. A loop within a single part, such as that of a torus, is not seen.
 *  - `Bounds` (double, 6 components): x, y, z from, to each.
 *  - `Centroid` (double, 3 components): of its triangles by area, of its lines by length.
 *  - `PrincipalLengths` (double, 3 components): the sides, descending, of the box with the same second
 *    moments: sqrt(12) times the standard deviations along the principal axes. A rectangle has its
 *    sides and 0.
 *
 * Output 2: vtkPolyData, the contact curves on the points of the axis: a polyline for each curve,
 * a vertex for a contact in one point. Cell data `ContactId` (vtkIdType). Field data: the parts that
 * touch along curve i, ascending, are `ContactParts`[`ContactPartOffsets`[i]] ...
 * `ContactParts`[`ContactPartOffsets`[i + 1] - 1] (vtkIdType).
 *
 * Output 3: vtkPolyData, the topology graph, to be drawn over the axis. Its nodes are groups of
 * contact curves connected through shared points, its edges the parts: each joins the nodes that it
 * touches, which may be none, one, two or more. A point and a vertex for each node (mean of the
 * points of its curves) and then for each part (centroid), and a line from the part to each of its
 * nodes.
 *  - `NodeId`, `PartId` (points and cells; vtkIdType): of a point one of the two, the other is -1; of
 *    a line both.
 *  - `Degree` (points; vtkIdType): the parts at a node; the nodes at a part.
 *  - `OnLoop` (points; unsigned char): 1 on a closed walk that uses no node and no part twice. The
 *    graph does not see a loop inside a single part.
 *
 * The field data of the input is passed on to output 0. An error (an array that is missing or does
 * not fit) leaves the outputs empty and sets the error code. Under MPI the piece 0 holds everything.
 *
 * See R. Tam, W. Heidrich, "Shape simplification based on the medial axis transform", IEEE
 * Visualization 2003, sections 4.1 to 4.3.
 *
 * @sa vtkMedialAxis vtkMedialPrune
 */

#ifndef vtkMedialPartDecomposition_h
#define vtkMedialPartDecomposition_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSMEDIAL_EXPORT vtkMedialPartDecomposition : public vtkPolyDataAlgorithm
{
public:
  static vtkMedialPartDecomposition* New();
  vtkTypeMacro(vtkMedialPartDecomposition, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Stops the run under way, or the next one where there is none. The outputs of a stopped run are empty;
   * the update after it makes them.
   */
  void SetAbortExecute(vtkTypeBool stop) override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* mtime) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * The colour in which pictures show a part, always the same for the same number (`PartRank` in ParaView,
   * `PartId` in the program's pictures): red, green and blue, 0 ... 1. Neighbouring numbers get very different colours. Light grey for numbers below 0,
   * which stand for no part. In Python: rgb = [0, 0, 0]; GetPartColor(part, rgb).
   */
  static void GetPartColor(vtkIdType part, double rgb[3]);

  ///@{
  /**
   * Parts farther from the border than this get level 0. 0, the default: no limit.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * Cut parts at necks too: limbs that the paper's parts leave on the rest, as a bunny's feet, become
   * parts of their own. A limb's largest radius is at most NeckRatio times that of what it is cut
   * off; see Core/Parts/Necks.h. Prune noise away first. Default off, 0.5.
   */
  vtkSetMacro(SplitAtNecks, bool);
  vtkGetMacro(SplitAtNecks, bool);
  vtkBooleanMacro(SplitAtNecks, bool);
  vtkSetClampMacro(NeckRatio, double, 0, 1);
  vtkGetMacro(NeckRatio, double);
  ///@}

protected:
  vtkMedialPartDecomposition();
  ~vtkMedialPartDecomposition() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMedialPartDecomposition(const vtkMedialPartDecomposition&) = delete;
  void operator=(const vtkMedialPartDecomposition&) = delete;

  int MaximumLevel = 0;
  bool SplitAtNecks = false;
  double NeckRatio = 0.5;
};

#endif
