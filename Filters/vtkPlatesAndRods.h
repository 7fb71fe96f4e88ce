// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlatesAndRods
 * @brief   plates and rods of a solid, such as trabecular bone, and one row for each
 *
 * Tells by a medial axis where the solid is a plate and where it is a rod, and cuts both into single
 * elements, as individual trabecula segmentation does on voxels. Lengths are in the unit of the
 * samples.
 *
 * At each point of the axis, with BT = `ErosionThickness` + `Radius` (when a fire from the border of the axis has
 * come there): one climbs along the sides of triangles, always the steepest one, to a summit of BT. There
 * the width is W = 2 BT. The thickness T is 2 `Radius` there; in plates, where balls bulge between samples, it is the
 * distance of the samples on both sides (`Lambda`). On lines, W = T. A rod with an elliptic section of half axes a
 * and b has W / T = a / b; within 3 per cent for samples 0.2 b apart. Plates are where W / T is more
 * than PlateRatio. What the fire does not reach (closed sheets, as of a hollow sphere) has a finite W of
 * more than twice the diagonal of the solid, which is no width: it is a plate.
 *
 * Elements: plates are cut along seams, where three or more sheets meet, and at necks. Rods are reduced to curves and cut
 * where three or more of them meet. What is too small for either belongs to what is next to it: a blob
 * where rods meet is a junction of these and no plate; a plate's rim is no rod. A rod between two plates that is
 * shorter than the sum of the radii at its ends is a neck of these.
 *
 * Input 0: vtkPolyData, the output of vtkMedialAxis, vtkMedialPartDecomposition or vtkMedialPrune. Prune noise
 * away first.
 *
 * Input 1, optional: vtkPolyData, the output of vtkPowerCrust that was made with this axis, or before it was
 * pruned.
 *
 * Output 0: vtkPolyData, input 0 with more arrays.
 *
 * Point data
 *  - `SheetWidth` (double): W.
 *  - `Thickness` (double): T, at the summit, not at the point: the distance of the samples on both sides in plates, the
 *    diameter of the maximal ball in rods.
 *  - `WidthRatio` (double): W / T.
 *  - `PlateOrRod` (unsigned char): 1 of a plate, 2 of a rod, 0 where no cell uses the point. That of
 *    the element, so it may differ from what W / T alone would say.
 *  - `ElementId` (vtkIdType): row of output 1; -1 where no cell uses the point.
 *
 * Cell data: `PlateOrRod` (active scalars), `ElementId` of the cell.
 *
 * Field data of outputs 0 and 1, 1 value each
 *  - `NumberOfPlates`, `NumberOfRods` (vtkIdType).
 *  - `PlateVolume`, `RodVolume` (double): sums of the column `Volume`.
 *  - `PlatePlateJunctions`, `PlateRodJunctions`, `RodRodJunctions` (vtkIdType): places where plates
 *    meet along a seam or neck, where rods hang on plates, and where three or more ends of rods, and no plate,
 *    meet. Three plates at one seam are one junction.
 *
 * Output 1: vtkTable, one row for each element, plates first
 *  - `ElementId` (vtkIdType), `PlateOrRod` (unsigned char; 1, 2).
 *  - `Volume` (double): of the Delaunay cells that count for the balls at its points and for those that share
 *    their fate (`BallOwner`). At a junction of rods the volume of the points in it is shared alike.
 *  - `Area` (double): of a plate's axis, once and not on both sides, without low sheets that stand on it; 0 for a rod.
 *  - `Length` (double): of a rod's curve, between the centres of its last balls, to the middle of a junction, or to
 *    where the plate begins; 0 for a plate.
 *  - `MeanThickness`, `MinimumThickness`, `MaximumThickness` (double): diameters of the maximal balls
 *    at its points; the mean weighted by volume. Rims count: at a sharp rim the least one is near 0.
 *  - `Centroid` (double, 3 components): of its cells.
 *  - `Direction` (double, 3 components): a plate's normal, a rod's axis, by second moments; of length 1, in the
 *    sense in which the largest component is positive.
 *  - `Neighbors` (vtkIdType): how many elements it meets. Their rows are, in the field data of
 *    the table, `NeighborElements`[`NeighborOffsets`[i]] ...
 *    `NeighborElements`[`NeighborOffsets`[i + 1] - 1] (vtkIdType), ascending.
 *
 * Output 2: vtkPolyData, input 1 with the cell data `PlateOrRod` (active scalars), `ElementId` and `Thickness` (T) of the
 * point of the axis that its `InnerBall` follows; 0, -1 and 0 where that ball is no longer on the axis. Empty without
 * input 1.
 *
 * An error (an array that is missing or does not fit) leaves the outputs empty and sets the error
 * code. Under MPI the piece 0 holds everything.
 *
 * The burn time: Y. Yan, K. Sykes, E. Chambers, D. Letscher, T. Ju, "Erosion thickness on medial axes
 * of 3D shapes", ACM Transactions on Graphics 35(4), 2016. Plates and rods as elements: X. S. Liu et al., "Complete
 * volumetric decomposition of individual trabecular plates and rods and its morphological correlations with
 * anisotropic elastic moduli in human trabecular bone", Journal of Bone and Mineral Research 23(2), 2008.
 *
 * @sa vtkMedialAxis vtkMedialPrune vtkPowerCrust
 */

#ifndef vtkPlatesAndRods_h
#define vtkPlatesAndRods_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSMEDIAL_EXPORT vtkPlatesAndRods : public vtkPolyDataAlgorithm
{
public:
  static vtkPlatesAndRods* New();
  vtkTypeMacro(vtkPlatesAndRods, vtkPolyDataAlgorithm);
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
   * Plates are wider than this many thicknesses. From 1 on, default 1.5.
   */
  vtkSetMacro(PlateRatio, double);
  vtkGetMacro(PlateRatio, double);
  ///@}

  ///@{
  /**
   * A plate is cut where its width falls below this part of the width on the narrower side, 0 ... 1.
   * Default 0.8; 0 cuts no necks.
   */
  vtkSetMacro(NeckRatio, double);
  vtkGetMacro(NeckRatio, double);
  ///@}

protected:
  vtkPlatesAndRods();
  ~vtkPlatesAndRods() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPlatesAndRods(const vtkPlatesAndRods&) = delete;
  void operator=(const vtkPlatesAndRods&) = delete;

  double PlateRatio = 1.5;
  double NeckRatio = 0.8;
};

#endif
