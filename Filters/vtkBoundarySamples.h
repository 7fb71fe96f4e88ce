// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBoundarySamples
 * @brief   samples of a solid's surface that suit its medial axis
 *
 * The vertices of a mesh are rarely good samples: a box has eight. This filter samples the surface
 * itself. The samples are random, evenly spread (blue noise), and closer together where the solid or a
 * gap is thin, so that opposite walls are several samples apart. Along sharp edges they come in
 * mirrored pairs, so that the sheets of the axis run straight into the edges. The same surface
 * gives the same samples.
 *
 * Input: any vtkPointSet with polygons that bound a solid. They are mended where that is clear: points
 * at the same place are made one (those that differ by rounding, too, if holes are left otherwise), repeated polygons and those without an area are dropped, all are
 * oriented, borders are stitched, holes smaller than a twentieth of the diagonal are filled. Cells
 * of other kinds are left out. Lengths are in the unit of the input.
 *
 * Polygons that bound no solid are refused, or with Wrap the closed surface around them is sampled.
 *
 * Output 0: vtkPolyData, the samples, a vertex cell each.
 *
 * Point data
 *  - `Normals` (float, 3 components): of the surface there, outwards.
 *  - `Spacing` (double, > 0, active scalars): how far the samples around it are apart at most.
 *  - `SourceCell` (vtkIdType): the polygon of the input that it lies on; -1: in a hole that was filled.
 *    Polygons are counted as they lie in the input, without cells of other kinds; each triangle of a
 *    strip counts.
 *
 * Output 1: vtkPolyData, the closed surface as it was used: triangles, counter-clockwise seen from
 * outside. Cell data: `SourceCell`, as above.
 *
 * Outputs 2 and 3: the polar balls of the samples (vtkUnstructuredGrid, the input of vtkMedialAxis), and the samples
 * with what is known about them (vtkPolyData). They were made to compare the samples with the solid. vtkPolarBalls
 * makes the same ones of outputs 0 and 1 and describes their arrays.
 *
 * Field data of the outputs, single values; later filters pass them on
 *  - `BettiSolid` (vtkIdType, 3 components): pieces, tunnels and voids of the solid, from the surface's
 *    pieces and their genus. vtkPowerCrust certifies only what has the same.
 *  - `SolidVolume`, `SolidArea` (double): of the surface.
 *  - `MergedPoints`, `DroppedPolygons`, `FilledHoles` (vtkIdType): what was mended.
 *  - `RefinementRounds` (vtkIdType): how often the samples were made denser, see SetMaximumRounds().
 *
 * Warnings, in the field data as vtkPolarBalls.h describes: `filled_holes`, `self_intersections`,
 * `wrapped` (Wrap was needed; with its offset),
 * `too_many_samples` (MaximumSamples was in the way), `paired_walls` (parallel walls are too near each other for their
 * samples, which come in mirrored pairs there; balls between them are too wide; with a place), `too_few_samples` (the balls of the samples don't
 * have the Betti numbers of the solid; with a place), `far_surface` (their power crust is farther than half a
 * spacing from the surface; with a place).
 *
 * An error (no polygons; a hole too large to fill; triangles of two pieces, or more than one in a hundred,
 * that intersect; a coordinate that is not finite) leaves the outputs empty and sets the error code. Under
 * MPI the piece 0 holds everything.
 *
 * @sa vtkPolarBalls vtkMedialAxis vtkSimplifyShape
 */

#ifndef vtkBoundarySamples_h
#define vtkBoundarySamples_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSMEDIAL_EXPORT vtkBoundarySamples : public vtkPolyDataAlgorithm
{
public:
  static vtkBoundarySamples* New();
  vtkTypeMacro(vtkBoundarySamples, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How far samples are apart at most, as a fraction of the thickness of the solid and of the gaps
   * outside it there; above 0, at most 1. Default 0.25.
   */
  vtkSetMacro(Fineness, double);
  vtkGetMacro(Fineness, double);
  ///@}

  ///@{
  /**
   * How far samples are apart at most anywhere, in the unit of the input. 0 (default): so that a
   * surface without thin places gets about as many samples as it has points, but at least 20,000 and at
   * most 50,000.
   */
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Sample thin places more densely? Off: the spacing is the same everywhere. Default on.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * No more samples than these, at least 4; thin places get fewer then, and a warning tells. Default
   * 1,000,000.
   */
  vtkSetMacro(MaximumSamples, vtkIdType);
  vtkGetMacro(MaximumSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * An edge is sharp where the normals of its two triangles differ by more, in degrees, 0 ... 180. Default
   * 30.
   */
  vtkSetMacro(SharpAngle, double);
  vtkGetMacro(SharpAngle, double);
  ///@}

  ///@{
  /**
   * How often samples are made denser at most. After each round, the power shape of their balls is
   * compared with the solid; where they contradict each other the spacing is halved. 0: the balls are made, but
   * not compared. Default 4.
   */
  vtkSetClampMacro(MaximumRounds, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumRounds, int);
  ///@}

  ///@{
  /**
   * Take the closed surface around the polygons where they bound no solid, because of holes, intersections or
   * pieces within each other? It encloses all of them, and fills what they enclose. Polygons that do bound a
   * solid are taken as they are. Default off.
   */
  vtkSetMacro(Wrap, bool);
  vtkGetMacro(Wrap, bool);
  vtkBooleanMacro(Wrap, bool);
  ///@}

  ///@{
  /**
   * Wrap goes across gaps and holes that are narrower, in the unit of the input. 0 (default): a twenty-fifth of
   * the diagonal of the points' bounding box.
   */
  vtkSetMacro(WrapWidth, double);
  vtkGetMacro(WrapWidth, double);
  ///@}

  ///@{
  /**
   * How far the wrap is outside the polygons, where no gap is too narrow, in the unit of the input. Less takes longer. 0
   * (default): a sixtieth of WrapWidth.
   */
  vtkSetMacro(WrapOffset, double);
  vtkGetMacro(WrapOffset, double);
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
  vtkBoundarySamples();
  ~vtkBoundarySamples() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  double Fineness = 0.25;
  double Spacing = 0;
  bool Adaptive = true;
  vtkIdType MaximumSamples = 1000000;
  double SharpAngle = 30;
  int MaximumRounds = 4;
  bool Wrap = false;
  double WrapWidth = 0;
  double WrapOffset = 0;

  vtkBoundarySamples(const vtkBoundarySamples&) = delete;
  void operator=(const vtkBoundarySamples&) = delete;
};

#endif
