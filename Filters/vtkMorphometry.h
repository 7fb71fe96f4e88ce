// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMorphometry
 * @brief   the numbers of bone morphometry of a solid: one row with the standard's names and units
 *
 * After the medial axis pipeline. The names are those of M. Bouxsein et al., "Guidelines for assessment of bone
 * microstructure in rodents using micro-computed tomography", J. Bone Miner. Res. 25(7), 2010, where they are there.
 *
 * Input 0: vtkUnstructuredGrid, the output of vtkPolarBalls.
 * Input 1: vtkPolyData, an axis that vtkMedialAxis or vtkMedialPrune made from these balls.
 * Input 2: vtkPolyData, the surface that vtkPowerCrust or vtkSimplifyShape made from these balls.
 * Inputs 1 and 2 may be collections, of which one block was made from them.
 *
 * Output 0: vtkTable with one row and the columns
 *  - `Name`, `Unit` (string): the properties.
 *  - One (double) for each quantity, in the order of GetQuantityName(). What can't be known is not a number,
 *    never 0.
 *  - `Betti:0`, `Betti:1`, `Betti:2`, `BettiSolid:0` ... (double): pieces, tunnels and voids of the surface's
 *    solid, and of the solid that was sampled, where it is known.
 *  - `Verdict` (string): that of the surface.
 *
 * Its field data: that of the balls and the surface, with its warnings and verdict, and
 *  - `ColumnUnits` (string, an entry for each column): the unit, such as mm^3; 1 for numbers, empty for texts.
 *
 * Output 1: vtkTable, what Tb.Th and Tb.Sp are means of, with histograms: the rows of output 1 of vtkLocalThickness whose
 * `Weight` is `volume`.
 *
 * The volume of interest is the bounding box of the samples, or Bounds, less Margin on each side. The first
 * holds the solid by definition: nothing is cut off where its surface is outside by less than the samples'
 * spacing. Where the volume of interest cuts the solid,
 *  - BV, BS, DA and Tb.NA are those of what is inside, without the cut itself;
 *  - Tb.Th and Tb.Sp are means over what is Margin inside the bounds, or half the mean thickness where there
 *    is no margin, as vtkLocalThickness says; unknown where that leaves nothing;
 *  - Euler is that of the whole solid and Conn.D is unknown: the Euler characteristic of the solid that is cut
 *    would count the cut;
 *  - Euler.VOI is the share of the volume of interest in the Euler characteristic, by the curvature of the
 *    surface inside. Shares of volumes side by side add up, so that Conn.D.VOI has no edge effects.
 * A solid that is cut already, as a cube of bone, has faces where it was cut: take a Margin that leaves
 * them out.
 *
 * A warning `coarse_for_thickness` tells where samples are more than 0.28 of the mean thickness apart.
 *
 * An error (an array that is missing or does not fit, axis or surface of other balls, a volume of interest of
 * which nothing is left) leaves the outputs empty and sets the error code. Under MPI the piece 0 holds everything.
 *
 * Ct.Th is known where the solid is one shell: one piece around one void, without tunnels, as a bone whose cortex is closed and
 * whose marrow is one cavity. It is Tb.Th then. A cortex with trabeculae inside, or cut open at its ends, can't be told from other
 * solids with tunnels: there it is not a number. Where you know that a solid is a cortex alone, take Tb.Th.
 *
 * Plates and rods are those of vtkPlatesAndRods with its default ratios. They count where their centroid is in the volume.
 *
 * @sa vtkLocalThickness vtkPowerCrust vtkMedialPrune vtkCollectParts
 */

#ifndef vtkMorphometry_h
#define vtkMorphometry_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkTableAlgorithm.h"

#include <string> // for texts

class VTKFILTERSMEDIAL_EXPORT vtkMorphometry : public vtkTableAlgorithm
{
public:
  static vtkMorphometry* New();
  vtkTypeMacro(vtkMorphometry, vtkTableAlgorithm);
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
   * Connects inputs 1 and 2.
   */
  void SetAxisConnection(vtkAlgorithmOutput* axis) { this->SetInputConnection(1, axis); }
  void SetAxisData(vtkDataObject* axis) { this->SetInputData(1, axis); }
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(2, surface); }
  void SetSurfaceData(vtkDataObject* surface) { this->SetInputData(2, surface); }
  ///@}

  ///@{
  /**
   * What the object is called, and the unit of its coordinates, such as mm: both are written into the table
   * and change nothing else. Default empty.
   */
  vtkSetStdStringFromCharMacro(Name);
  vtkGetCharFromStdStringMacro(Name);
  vtkSetStdStringFromCharMacro(Unit);
  vtkGetCharFromStdStringMacro(Unit);
  ///@}

  ///@{
  /**
   * Is the volume of interest given by Bounds (least and largest x, y and z, in the samples' unit), and not the
   * bounding box of the samples? Default off.
   */
  vtkSetMacro(UseBounds, bool);
  vtkGetMacro(UseBounds, bool);
  vtkBooleanMacro(UseBounds, bool);
  vtkSetVector6Macro(Bounds, double);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * By how much the volume of interest is smaller on each side, in the samples' unit. Default 0.
   */
  vtkSetMacro(Margin, double);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /**
   * The table of quantities: name, unit for this unit of length, what it is, and its formula from others, empty
   * where it is measured. Null where there is no such quantity; numbers begin at 0.
   */
  static const char* GetQuantityName(int quantity);
  static std::string GetQuantityUnit(int quantity, const char* length);
  static const char* GetQuantityDescription(int quantity);
  static const char* GetQuantityFormula(int quantity);
  ///@}

  /**
   * Why the last update failed: the message without VTK's file, line and object. Empty if there was no error.
   */
  const char* GetErrorMessage();

protected:
  vtkMorphometry();
  ~vtkMorphometry() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMorphometry(const vtkMorphometry&) = delete;
  void operator=(const vtkMorphometry&) = delete;

  std::string Name;
  std::string Unit;
  bool UseBounds = false;
  double Bounds[6] = { 0, 1, 0, 1, 0, 1 };
  double Margin = 0;
};

#endif
