// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMedialAxis
 * @brief   the surface of the centres of a solid's maximal balls
 *
 * Second filter of the medial axis pipeline.
 *
 * Input: vtkUnstructuredGrid, the output of vtkPolarBalls.
 *
 * Output: vtkPolyData. A point is the centre of a maximal ball. Cells are the triangles of the
 * axis, lines where it is a curve ("dangling edges"), and vertices where it is a point; numbered
 * vertices, lines, triangles. No two points lie at the same place and every edge is shared, so there
 * are no cracks.
 *
 * Point data
 *  - `BallId` (vtkIdType): the ball centred there, a point of the input; or -1.
 *  - `Radius`, `MaximumInscribedSphereRadius` (double, > 0): of the maximal ball, unit of the
 *    samples. The same values twice; other tools know the second name.
 *  - `ErosionThickness` (double, >= 0, unit of the samples): burn time - radius, when everything at the
 *    point has burnt, see README.md.
 *
 * Cell data
 *  - `PolygonId` (vtkIdType): triangles of one face have the same; -1 for lines and vertices.
 *  - `SiteSamples` (vtkIdType, 2 components): the two samples that the cell is equally far from; -1
 *    where such a point is no sample.
 *  - `ObjectAngle` (double, 0 ... 180 degrees): the largest angle at which two of the cell's sites are
 *    seen from its centroid. A triangle has two sites, a line three. Where they aren't known (lines
 *    of the fallback, and small faces that were filled in) the points where the spheres of its
 *    corners meet stand for them.
 *  - `Lambda` (double, unit of the samples): the largest distance of two of the cell's sites; 0 where
 *    the spheres don't meet.
 *  - `ErosionThickness` (double, >= 0): the largest at its corners, when the fire comes there in the
 *    cell's own sheet.
 *
 * Field data, one entry for each ball (point of the input)
 *  - `BallOwner` (vtkIdType): itself where it is on the axis; for an inner ball off the axis the ball
 *    on the axis whose fate it shares; else -1.
 *  - `BallVolume`, `BallPoleVolume` (double): `Volume` and `PoleVolume` of the input.
 *
 * Field data, single values
 *  - `BettiPowerShape`, `BettiAxis` (vtkIdType, 3 components): pieces, tunnels and voids of the
 *    power shape and of the axis, each computed from its own cells.
 *  - `BettiUnprunedAxis` (vtkIdType, 3 components): the same as `BettiAxis`; it stays when the axis is
 *    pruned.
 *  - `TopologyKept` (unsigned char): 1; 0 once a pruning was allowed to change the topology.
 *  - `Certificate` (unsigned char): 1 where `BettiAxis` and `BettiPowerShape` are equal.
 *  - `Fallback` (unsigned char): 1 where the axis, or connected pieces of it, was made by collapse
 *    of the power shape.
 *  - `Kappa` (double): which Voronoi vertices were candidates, see README.md; -1 with the fallback.
 *  - `FilledGaps` (vtkIdType): places where vertices beyond these candidates were taken, to fill a gap
 *    that the power shape doesn't have; 0 where none had to be, and with the fallback.
 *  - `NumberOfOffAxisBalls` (vtkIdType): inner balls that are not on the axis.
 *
 * An axis made by the fallback becomes a warning, with the code `fallback`, see vtkPolarBalls.
 *
 * The field data of the input is passed on, but for `Samples`, `SampleInnerBall`, `SampleOuterBall`,
 * `BallSampleOffsets` and `BallSamples`, which are long: what reads them reads the balls. An error (an
 * array that is missing or does not fit, no inner balls) leaves the output empty and sets the error
 * code. Under MPI the piece 0 holds everything.
 *
 * See R. Tam, W. Heidrich, "Shape simplification based on the medial axis transform", IEEE
 * Visualization 2003, sections 2.1 and 3.
 *
 * @sa vtkPolarBalls vtkMedialPartDecomposition
 */

#ifndef vtkMedialAxis_h
#define vtkMedialAxis_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

namespace medial
{
class SharedBalls;
}

class VTKFILTERSMEDIAL_EXPORT vtkMedialAxis : public vtkPolyDataAlgorithm
{
public:
  static vtkMedialAxis* New();
  vtkTypeMacro(vtkMedialAxis, vtkPolyDataAlgorithm);
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

  enum FallbackMode
  {
    COLLAPSE = 0,
    NEAREST = 1
  };

  ///@{
  /**
   * What to do where the axis does not have the topology of the power shape: collapse the power
   * shape, which has exactly its topology but coarser triangles (COLLAPSE, the default), or keep the
   * axis that comes nearest (NEAREST), which `Certificate` then tells.
   */
  vtkSetClampMacro(Fallback, int, COLLAPSE, NEAREST);
  vtkGetMacro(Fallback, int);
  void SetFallbackToCollapse() { this->SetFallback(COLLAPSE); }
  void SetFallbackToNearest() { this->SetFallback(NEAREST); }
  ///@}

  ///@{
  /**
   * Leave out rims of the axis up to this erosion thickness: long spikes, and sheets around round shafts, that small
   * bumps of the surface make. In local spacings of the samples (mean distances from their six nearest), >= 0; 0.2
   * takes most of them. The topology stays, and so does the solid: without pruning the surface is the same. What is
   * left of a sheet that is thin everywhere is a line. At sharp corners, where sheets meet, it may join two of them.
   * Default 0: none.
   */
  vtkSetClampMacro(Trim, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(Trim, double);
  ///@}

protected:
  vtkMedialAxis() = default;
  ~vtkMedialAxis() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMedialAxis(const vtkMedialAxis&) = delete;
  void operator=(const vtkMedialAxis&) = delete;

  int Fallback = COLLAPSE;
  double Trim = 0;

  friend class vtkSimplifyShape;
  medial::SharedBalls* Shared = nullptr; ///< set while vtkSimplifyShape works
};

#endif
