// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolarBalls
 * @brief   balls inside and outside a solid that is given by points of its boundary
 *
 * First filter of the medial axis pipeline. A polar ball is centred at a pole, a farthest Voronoi
 * vertex of a sample's cell; one ball stands for all Delaunay cells with the same circumsphere.
 *
 * Input: any vtkPointSet. Its points are the samples. Its cells make no difference to the result, but
 * where they are the polygons of an open surface, that is warned of. Lengths are in the
 * unit of the samples, volumes in its cube. Where the samples have normals (the active ones, or the point
 * array `Normals`, 3 components, outwards, of any length), these tell which balls are inside. A second input, the surface of the solid, is optional; see
 * SetSolidConnection(). Repeated points count once, also where they differ by
 * rounding only, see SetMergeTolerance().
 *
 * Output 0: vtkUnstructuredGrid, the balls, as the next filters take them. A point is the centre of a
 * ball, a cell a tetrahedron of the regular triangulation of the balls with their squared radii as
 * weights. This one object is the dual of the power diagram: its cells with four inner corners are the
 * power shape.
 *
 * Point data
 *  - `Radius` (double, > 0): of the ball.
 *  - `InnerRadius` (double, active scalars): the same where the ball is inner, else 0; to draw the inner balls.
 *  - `Side` (unsigned char): 0 outer, 1 inner, 2 hidden (it has no cell in the power diagram).
 *  - `TouchesGuard` (unsigned char, 0 or 1): it passes through a corner of the cube around the samples.
 *  - `Volume` (double): of the Delaunay cells that count for it; 0 where it is not inner.
 *  - `PoleVolume` (double): of only the cells for whose circumsphere the ball stands.
 *
 * Field data, one entry for each sample, in the order of the input
 *  - `Samples` (double, 3 components): where it is.
 *  - `SampleInnerBall`, `SampleOuterBall` (vtkIdType): its ball inside and outside, or -1. Where poles crowd, as
 *    near the axis of a tube, one ball stands for all; it passes their samples within a hundredth of the
 *    distance of these to the next sample.
 *  - `SampleNormals` (double, 3 components): of the surface there, outwards, of length 1; zero where it has none or counts as
 *    another sample. Only where the samples have normals that are of use.
 *
 * Field data, lists: the samples on ball i, ascending, are `BallSamples`[`BallSampleOffsets`[i]] ...
 * `BallSamples`[`BallSampleOffsets`[i + 1] - 1] (vtkIdType).
 *
 * Field data, single values
 *  - `NumberOfSamples`, `NumberOfDuplicates`, `NumberOfInnerBalls`, `NumberOfOuterBalls`,
 *    `NumberOfHiddenBalls` (vtkIdType).
 *  - `MergeTolerance` (double, >= 0): the distance within which samples counted as one, or the largest
 *    one of two that did.
 *  - `SampleSpacing` (double, > 0): mean distance of a distinct sample to the nearest other one.
 *  - `BettiPowerShape` (vtkIdType, 3 components): pieces, tunnels and voids of the power shape,
 *    which are those of the solid.
 *  - `BettiSolid` (vtkIdType, 3 components): those of the surface of the solid, where it is known.
 *
 * Output 1: vtkPolyData, the samples, to look at. A point is a sample, in the order of the input, with
 * repeated ones; there is a vertex cell for each.
 *
 * Point data
 *  - `SamplingQuality` (double, -1 ... 1, active scalars): -cos of the angle at which the sample sees
 *    its two poles. 1 is best; 0 and less: an edge of the solid, or too few samples.
 *  - `InnerBall`, `OuterBall` (vtkIdType): its ball inside and outside, a point of output 0, or -1. The
 *    same as `SampleInnerBall` and `SampleOuterBall`.
 *  - `DuplicateOf` (vtkIdType): the sample that it counts as, at the same place or within the merge
 *    tolerance of it, or -1.
 *
 * Warnings: what is doubtful of the samples or of the result is sent as VTK's warning events, each by the
 * filter that finds it. It is also in the field data of both outputs and of all outputs made from them:
 * one entry for each warning, with those of the filters before. Without a warning the arrays aren't
 * there.
 *  - `WarningCode` (string): the kind, for programs: `open_surface` (edges with a polygon on one side
 *    only), `fallback` (see vtkMedialAxis), and those in README.md.
 *  - `WarningText` (string): what was seen and what to do, for people.
 *  - `WarningCount` (vtkIdType): how many samples, edges, ... it is about.
 *  - `WarningPlace` (double, 3 components), `WarningHasPlace` (unsigned char): where one of them is; 0 0 0
 *    and 0 where it is about all.
 *  - `WarningDoubtsSolid` (unsigned char): 1 where the samples may not determine the solid, so that
 *    nothing made from them is certified, see vtkPowerCrust. An open surface does not: its points may be
 *    dense everywhere.
 *
 * The field data of the input is passed on to both, but for the verdict on a surface of an earlier run. An
 * error (fewer than 4 distinct points, all on a
 * line or in a plane, a coordinate that is not finite) leaves the outputs empty and sets the error
 * code. Under MPI the piece 0 holds everything.
 *
 * See R. Tam, W. Heidrich, "Shape simplification based on the medial axis transform", IEEE
 * Visualization 2003, section 2; N. Amenta, S. Choi, R. Kolluri, "The power crust", 2001.
 *
 * @sa vtkMedialAxis vtkPowerCrust
 */

#ifndef vtkPolarBalls_h
#define vtkPolarBalls_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkPolyData;

class VTKFILTERSMEDIAL_EXPORT vtkPolarBalls : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkPolarBalls* New();
  vtkTypeMacro(vtkPolarBalls, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Samples within this distance of each other count as one, if no other sample is within ten times
   * the distance: copies of a place that differ by rounding. Samples that are denser than that all
   * count. In the unit of the samples; 0: only samples at the very same place count as one.
   * 0 takes samples as exact for their balls, too: else those that miss a ball by rounding are on it.
   *
   * Negative (default -1): two units in the last place of the input's coordinates, but at least 1e-7 of
   * the diagonal of their bounding box. The unit is that of floats or doubles at the largest
   * coordinate; for coordinates that were rounded to more, as in a text, it is the one value of the
   * input's field array `SampleResolution` (double, >= 0). Further, at any distance, clusters of less
   * than fifty samples count as one if all others are 200 times as far away as the cluster is large.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * The surface of the solid, optional: triangles that are closed, in the coordinates of the samples, such
   * as output 1 of vtkBoundarySamples. A ball is then inner if its centre is inside, the output has
   * `BettiSolid`, and nothing about the samples is doubted: vtkPowerCrust compares the results with the
   * solid.
   */
  void SetSolidConnection(vtkAlgorithmOutput* surface);
  void SetSolidData(vtkPolyData* surface);
  ///@}

  /**
   * Stops the run under way, or the next one where there is none. The outputs of a stopped run are empty;
   * the update after it makes them.
   */
  void SetAbortExecute(vtkTypeBool stop) override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* mtime) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkPolarBalls();
  ~vtkPolarBalls() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  double MergeTolerance = -1;

  vtkPolarBalls(const vtkPolarBalls&) = delete;
  void operator=(const vtkPolarBalls&) = delete;
};

#endif
