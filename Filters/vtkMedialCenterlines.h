// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMedialCenterlines
 * @brief   lines along the middle of rods and tubes
 *
 * The medial axis of a rod is a string of narrow sheets. This filter makes one line of it, from fork to
 * fork or end, without being told where a vessel tree, a spring or a network of trabeculae begins and
 * ends. Loops are kept. A tube is a rod if its inside is the solid; the axis of the wall of a hollow tube is
 * a plate.
 *
 * Input: vtkPolyData, the output of vtkMedialAxis or vtkMedialPrune.
 *
 * Output 0: vtkPolyData, a polyline for each branch. Branches share the points of the nodes where they meet: the
 * first points are the nodes of output 1, in their order. A loop that meets nothing ends with its first point.
 *
 * Point data
 *  - `MaximumInscribedSphereRadius` (double, active scalars): of the largest ball about the point in
 *    the solid. Vmtk's filters read this array.
 *
 * Cell data
 *  - `BranchId` (vtkIdType): number of the branch, which is the cell's own.
 *  - `BranchNodes` (vtkIdType, 2 components): the nodes at its first and last point; -1 twice for a loop that
 *    meets nothing.
 *  - `Length` (double, unit of the samples).
 *  - `MeanRadius`, `MinimumRadius` (double): along the branch.
 *
 * Field data: `OpenedVoids` (vtkIdType, 1 value): closed sheets around voids, which a line can't go
 * around; none of them is left where WidthRatio is 0.
 *
 * Output 1: vtkPolyData, a vertex for each node, where branches meet or end.
 *  - `NodeId` (points; vtkIdType): number of the node, which is the point's own.
 *  - `MaximumInscribedSphereRadius` (points; double).
 *  - `Degree` (points; vtkIdType): the ends of branches there.
 *  - `AtPlate` (points; unsigned char): 1 where a rod goes on as a plate.
 *
 * What is a rod? A sheet of the axis is as wide as twice `ErosionThickness` + `Radius` in its middle, and the
 * solid as thick as twice the radius there. Places where the width is more than WidthRatio times the thickness,
 * over a length of at least the thickness, are plates. Branches end there. With a WidthRatio of 0 they go through
 * plates, along their middle; then they are connected as the axis is, and have its loops.
 *
 * What is no rod of its own: a branch that sticks out of another by less than a radius, and what begins and
 * ends within a diameter of a fork; forks so near to each other become one. A rod that is cut off straight has
 * its line end one radius before the cut, as its axis does.
 *
 * How exact: lines are in the middle and radii right to about a hundredth of the radius; within two radii of a fork, where rods are
 * continued straight, to about a twentieth, single points to a tenth.
 *
 * The field data of the axis is passed on to output 0, but not that of its balls. An error (an array that is missing or does not fit)
 * leaves the outputs empty and sets the error code. Under MPI the piece 0 holds everything.
 *
 * @sa vtkMedialAxis vtkMedialPrune
 */

#ifndef vtkMedialCenterlines_h
#define vtkMedialCenterlines_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSMEDIAL_EXPORT vtkMedialCenterlines : public vtkPolyDataAlgorithm
{
public:
  static vtkMedialCenterlines* New();
  vtkTypeMacro(vtkMedialCenterlines, vtkPolyDataAlgorithm);
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

  ///@{
  /**
   * Up to so many times as wide as thick, a sheet of the axis is a rod; beyond, it is a plate. Default 1.5, as for
   * elliptic rods whose axes are 3 : 2. 0: lines go through plates, too.
   */
  vtkSetClampMacro(WidthRatio, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(WidthRatio, double);
  ///@}

protected:
  vtkMedialCenterlines();
  ~vtkMedialCenterlines() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMedialCenterlines(const vtkMedialCenterlines&) = delete;
  void operator=(const vtkMedialCenterlines&) = delete;

  double WidthRatio = 1.5;
};

#endif
