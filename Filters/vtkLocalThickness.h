// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLocalThickness
 * @brief   how thick a solid is, and how wide its gaps are
 *
 * The thickness at a place is the diameter of the largest ball inside the solid that contains it, the separation that
 * of the largest ball outside [HR97]. The polar balls hold all of these. Lengths are in the unit of the samples.
 *
 * Balls bulge between samples of a flat wall, by about a tenth of the thickness where the samples are a quarter of it
 * apart. So the diameter of a ball is taken as twice its mean distance from the walls that it touches, to second order in
 * their curvature. The walls' normals are those that came with the samples (`SampleNormals` of the balls); else paraboloids
 * are fitted to neighbouring samples. With samples up to 0.28 of the thickness apart the mean thickness is right
 * within 1 %; coarser ones make it too large.
 *
 * Input 0: vtkUnstructuredGrid, the balls of vtkPolarBalls or vtkBoundarySamples.
 * Input 1 (optional): any vtkDataSet, at whose points to measure, such as the surface of vtkPowerCrust, a mesh or an image.
 * Without it the samples are measured.
 * Input 2 (optional): vtkPolyData, the axis of vtkMedialAxis, vtkMedialPartDecomposition or vtkMedialPrune made from
 * these balls. Then thin places are looked for.
 *
 * Output 0: input 1, or the samples as vertices, with point data
 *  - `Thickness` (double): not a number where no inner ball contains the point.
 *  - `ThicknessBall` (vtkIdType): that ball, a point of input 0, or -1.
 *  - `Separation`, `SeparationBall`: the same of outer balls, with MeasureSeparation. Balls that reach a corner of the cube
 *    around the samples don't count.
 *
 * Output 1: vtkTable, a row for each mean, with columns `Quantity` (Thickness, Separation), `Weight`, `Mean`, `Deviation`,
 * `Minimum`, `Maximum`, `Number` (of values), `Histogram` (vtkIdType, 40 components: how many values are in each fortieth of
 * the range from 0 to the maximum). Not a number where there is no value. By `Weight`:
 *  - `volume`: at NumberOfPoints points spread evenly over the volume of interest. This is Tb.Th and Tb.Sp of
 *    bone morphometry. Separation counts where an outer ball contains the point whose centre is in the volume.
 *  - `places`: at the points of output 0, each once.
 *  - `balls`: of the inner balls, each once. It depends on the sampling.
 *
 * Field data of this table: `Margin` (double), what was left out at the bounds; `VolumeShare` (double), the share of the
 * volume of interest that is inside the solid.
 *
 * Output 2: vtkTable, a row for each thin place, the thinnest first; empty without input 2. A thin place is a minimum of
 * thickness on the axis, between walls that face each other, from which the thickness rises by MinimumDepth on each way
 * to a thinner place. Sharp edges are none. Columns
 *  - `Place` (double, 3 components), `Thickness` (double).
 *  - `Depth` (double): by what share the thickness rises; infinite where there is no way to a thinner place.
 *  - `AxisPoint` (vtkIdType): the point of input 2.
 *  - `PartId` (vtkIdType): its part, where input 2 has parts.
 *
 * Output 0 has the field data of all inputs. An error leaves the outputs empty and sets the error code. Under MPI the piece 0 holds everything.
 *
 * See T. Hildebrand, P. Rueegsegger, "A new method for the model-independent assessment of thickness in
 * three-dimensional images", J. Microscopy 185, 1997.
 *
 * @sa vtkPolarBalls vtkMedialAxis
 */

#ifndef vtkLocalThickness_h
#define vtkLocalThickness_h

#include "vtkDataSetAlgorithm.h"
#include "vtkFiltersMedialModule.h" // for export macro

class VTKFILTERSMEDIAL_EXPORT vtkLocalThickness : public vtkDataSetAlgorithm
{
public:
  static vtkLocalThickness* New();
  vtkTypeMacro(vtkLocalThickness, vtkDataSetAlgorithm);
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
   * Where to measure (input 1), and the axis for thin places (input 2). SetInputConnection(1, ...) is the same.
   */
  void SetPlacesConnection(vtkAlgorithmOutput* places) { this->SetInputConnection(1, places); }
  void SetPlacesData(vtkDataObject* places) { this->SetInputData(1, places); }
  void SetAxisConnection(vtkAlgorithmOutput* axis) { this->SetInputConnection(2, axis); }
  void SetAxisData(vtkDataObject* axis) { this->SetInputData(2, axis); }
  ///@}

  ///@{
  /**
   * How far outside of a ball a place may be, in mean distances between neighbouring samples: the surface is not exactly
   * where the balls are. At least 0, default 0.25. The means over the volume don't depend on it.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Is the separation measured at the places, too? Default on. It takes longer than the thickness.
   */
  vtkSetMacro(MeasureSeparation, bool);
  vtkGetMacro(MeasureSeparation, bool);
  vtkBooleanMacro(MeasureSeparation, bool);
  ///@}

  ///@{
  /**
   * A box, as a volume of interest for the means over the volume: where something larger was cut. Lower and upper bound of
   * x, y and z. Default off: the bounding box of the samples, which cuts nothing.
   */
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * How far inside the bounds thickness counts, in the unit of the samples: at a cut, balls are too small. Negative, the
   * default: half the mean thickness; where that leaves nothing of the bounds, the mean thickness isn't known.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * At how many points inside, and as many outside, the means over the volume are measured. 0: they are not. Default 10000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 0, 10000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * By what share the thickness must rise around a thin place. At least 0, default 0.1.
   */
  vtkSetMacro(MinimumDepth, double);
  vtkGetMacro(MinimumDepth, double);
  ///@}

protected:
  vtkLocalThickness();
  ~vtkLocalThickness() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkLocalThickness(const vtkLocalThickness&) = delete;
  void operator=(const vtkLocalThickness&) = delete;

  double Tolerance = 0.25;
  bool MeasureSeparation = true;
  bool UseBounds = false;
  double Bounds[6] = { 0, 1, 0, 1, 0, 1 };
  double Margin = -1;
  int NumberOfPoints = 10000;
  double MinimumDepth = 0.1;
};

#endif
