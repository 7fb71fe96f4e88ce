// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImageBoundary
 * @brief   the closed, smoothed surface of a solid in an image
 *
 * From the voxels of a CT, or of a label map, to the mesh that vtkBoundarySamples samples, in these
 * steps, each of which can be switched off:
 *  1. The voxels of the solid are those of at least an iso value, or those of a label.
 *  2. Small cavities are filled: SetFillCavities().
 *  3. Small pieces are dropped: SetPieces().
 *  4. The image is padded, so that a solid that reaches its border is closed there: SetPad().
 *  5. The mask is smoothed by a Gaussian: SetGaussianRadius(). It takes away steps, and what is thinner
 *     than about two voxels. Cavities and pieces that it makes are filled and dropped like the others.
 *  6. Its surface at one half (vtkFlyingEdges3D) is smoothed without shrinking
 *     (vtkWindowedSincPolyDataFilter): SetSmoothingIterations(), SetPassBand(). Walls and gaps stay at
 *     least about half as thick as they were; the two steps leave none that samples can't resolve.
 *
 * Input: vtkImageData with a number for each voxel, as point data: the active scalars, or the array that
 * SetInputArrayToProcess() names. Spacing and direction of the image are heeded; all lengths of
 * the steps are in voxels, since segmentation and noise are of voxels.
 *
 * Output 0: vtkPolyData, the surface in space: triangles, counter-clockwise seen from outside.
 *
 * Output 1: vtkImageData, the voxels as they were used, padded. Point data: `Mask` (unsigned char, 1 in
 * the solid, else 0).
 *
 * Field data of both outputs; later filters pass them on
 *  - `IsoValue` or `Label` (double): what told the solid.
 *  - `BettiSegmentation` (vtkIdType, 3 components): pieces, tunnels and voids of the mask; its voxels are
 *    connected where they share a corner.
 *  - `BettiBoundary` (vtkIdType, 3 components): of the surface, 0 0 0 if it is not closed.
 *  - `FilledCavities`, `FilledVoxels`, `DroppedPieces`, `DroppedVoxels` (vtkIdType): what steps 2 and 3 did.
 *  - `PaddedVoxels` (vtkIdType): on each side.
 *  - `CutVoxels` (vtkIdType, 6 components): voxels of the solid at the first and last i, j and k.
 *
 * Warnings, in the field data as vtkPolarBalls.h describes: `cut_at_border`, `smoothed_topology` (the
 * surface has other Betti numbers than the voxels); both with a place.
 *
 * An error (no array; an iso value that no surface is at, a label that no voxel has, and then those that
 * there are; NaN; every voxel or none is of the solid; less than two voxels in a direction; too
 * many voxels, 2^31) leaves the outputs empty and sets the error code. Under MPI the piece 0 holds
 * everything.
 *
 * @sa vtkBoundarySamples vtkSimplifyShape
 */

#ifndef vtkImageBoundary_h
#define vtkImageBoundary_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

namespace medial
{
struct BoundaryOptions;
}

class VTKFILTERSMEDIAL_EXPORT vtkImageBoundary : public vtkPolyDataAlgorithm
{
public:
  static vtkImageBoundary* New();
  vtkTypeMacro(vtkImageBoundary, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What tells the voxels of the solid.
  enum SolidMode
  {
    AUTO = 0, ///< the image has two values; the one that isn't 0, else the larger one, is the solid
    ISO_VALUE = 1, ///< voxels of at least IsoValue
    LABEL = 2      ///< voxels of Label
  };

  ///@{
  /**
   * Default AUTO: an error lists the values where there are more than two.
   */
  vtkSetClampMacro(Solid, int, AUTO, LABEL);
  vtkGetMacro(Solid, int);
  void SetSolidToAuto() { this->SetSolid(AUTO); }
  void SetSolidToIsoValue() { this->SetSolid(ISO_VALUE); }
  void SetSolidToLabel() { this->SetSolid(LABEL); }
  ///@}

  ///@{
  /**
   * With ISO_VALUE: above the least and up to the largest value of the image. Default 0.5.
   */
  vtkSetMacro(IsoValue, double);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * With LABEL: a value of the image. Default 1.
   */
  vtkSetMacro(Label, double);
  vtkGetMacro(Label, double);
  ///@}

  ///@{
  /**
   * Cavities of at most so many voxels become part of the solid, with all that lies in them; from 0 (none)
   * on. Default 50.
   */
  vtkSetClampMacro(FillCavities, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(FillCavities, vtkIdType);
  ///@}

  /// Which connected pieces of the solid are kept.
  enum PieceChoice
  {
    FROM_SIZE = 0, ///< those of at least MinimumPieceVoxels
    LARGEST = 1    ///< the largest
  };

  ///@{
  /**
   * Default FROM_SIZE.
   */
  vtkSetClampMacro(Pieces, int, FROM_SIZE, LARGEST);
  vtkGetMacro(Pieces, int);
  void SetPiecesToFromSize() { this->SetPieces(FROM_SIZE); }
  void SetPiecesToLargest() { this->SetPieces(LARGEST); }
  ///@}

  ///@{
  /**
   * With FROM_SIZE: from 1 (all) on. Default 50.
   */
  vtkSetClampMacro(MinimumPieceVoxels, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(MinimumPieceVoxels, vtkIdType);
  ///@}

  ///@{
  /**
   * Close the solid by flat faces where it reaches the border of the image? Off: the surface is open
   * there. Default on.
   */
  vtkSetMacro(Pad, bool);
  vtkGetMacro(Pad, bool);
  vtkBooleanMacro(Pad, bool);
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian, in voxels, 0 (none) to 10. Default 0.7.
   */
  vtkSetClampMacro(GaussianRadius, double, 0, 10);
  vtkGetMacro(GaussianRadius, double);
  ///@}

  ///@{
  /**
   * Of vtkWindowedSincPolyDataFilter, 0 (none) to 1000. Default 20.
   */
  vtkSetClampMacro(SmoothingIterations, int, 0, 1000);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /**
   * Of vtkWindowedSincPolyDataFilter, 0.001 ... 2; less is smoother. Default 0.1.
   */
  vtkSetClampMacro(PassBand, double, 0.001, 2);
  vtkGetMacro(PassBand, double);
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
  vtkImageBoundary();
  ~vtkImageBoundary() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  medial::BoundaryOptions Options() const;

  int Solid = AUTO;
  double IsoValue = 0.5;
  double Label = 1;
  vtkIdType FillCavities = 50;
  int Pieces = FROM_SIZE;
  vtkIdType MinimumPieceVoxels = 50;
  bool Pad = true;
  double GaussianRadius = 0.7;
  int SmoothingIterations = 20;
  double PassBand = 0.1;

  vtkImageBoundary(const vtkImageBoundary&) = delete;
  void operator=(const vtkImageBoundary&) = delete;
};

#endif
