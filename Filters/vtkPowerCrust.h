// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPowerCrust
 * @brief   the closed surface between inner and outer polar balls
 *
 * Last filter of the medial axis pipeline: from a pruned axis back to a surface.
 *
 * Input 0: vtkUnstructuredGrid, the output of vtkPolarBalls.
 * Input 1 (optional): vtkPolyData, an axis that vtkMedialAxis or vtkMedialPrune made from these
 * balls, or a collection of axes, of which one was. Then the inner balls on its cells, and the balls
 * they own, are kept. Without it all inner balls are, as if nothing had been pruned; a warning says so.
 *
 * Output: vtkPolyData, triangles, oriented outwards: their points are counter-clockwise seen from
 * outside.
 *
 * Point data
 *  - `SampleId` (vtkIdType): the sample that the point is, or -1. Each sample is one point at most. No two
 *    points are at the same place, so the surface stays closed in a file that knows points by their places.
 *
 * Cell data
 *  - `InnerBall` (vtkIdType): the ball behind the triangle, a point of input 0.
 *  - `OuterBall` (vtkIdType): the ball in front of it; -1 for a ball that the rule has added.
 *  - `PartId` (vtkIdType): the part of the axis that the inner ball counts for; -1 for a ball that was
 *    put back, without input 1 or where that has no array `PartId`.
 *  - `PartRank` (vtkIdType): the rank of that part, see vtkMedialPartDecomposition; -1 where there is none.
 *
 * Field data, single values
 *  - `BettiCrust` (vtkIdType, 3 components): pieces, tunnels and voids of the enclosed solid.
 *  - `Closed` (unsigned char): 1 where every edge lies between two triangles, in opposite directions.
 *  - `Manifold` (unsigned char): 1 where moreover the triangles at every point form one fan.
 *  - `Volume` (double): enclosed, cube of the samples' unit.
 *  - `PutBackBalls` (vtkIdType): removed inner balls that the rule has put back, because the solid
 *    would have another topology than the axis without them.
 *  - `InsertedBalls`, `RefusedBalls`, `Rounds` (vtkIdType): outer balls that the rule has added, those
 *    it has not because the topology would have changed, and the rounds made.
 *  - `MaximumClearance` (double): largest distance of a point that is no sample to the union of the
 *    kept balls and those put back, in sample spacings; 0 where none is outside.
 *  - `MovedBy`, `MovedAtMost` (double): what pruning has moved: 99 % of the samples, and all of them, are
 *    at most this far from the surface, in the samples' unit. 0 where all balls are kept.
 *
 * Field data, the verdict on this surface and on all stages before it
 *  - `Verdict` (string): `certified` or `not certified`. Certified is a surface if the power shape, the
 *    axis, the pruned axis and the enclosed solid have the same Betti numbers, it is closed and a
 *    manifold, and no warning says that the samples may not determine the solid. Where pruning was allowed
 *    to change the topology, the pruned axis may differ from the axis. Without input 1 no surface is
 *    certified, since the axis is not known. An axis made by the fallback has the right topology, so its
 *    surface can be certified; there is a warning.
 *  - `VerdictReasons` (string): what differs or speaks against it, a sentence each; not there where
 *    nothing does. A surface that is not certified is also a warning event.
 *
 * The field data of input 0 is passed on as by vtkMedialAxis, with the warnings of both inputs (see
 * vtkPolarBalls). An error (an array that is missing or
 * does not fit, an axis of other balls, no ball kept) leaves the output empty and sets the error code.
 * Under MPI the piece 0 holds everything.
 *
 * See N. Amenta, S. Choi, R. Kolluri, "The power crust", 2001; R. Tam, W. Heidrich, "Shape
 * simplification based on the medial axis transform", IEEE Visualization 2003, section 5.
 *
 * @sa vtkPolarBalls vtkMedialPrune
 */

#ifndef vtkPowerCrust_h
#define vtkPowerCrust_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

namespace medial
{
class SharedBalls;
}

class VTKFILTERSMEDIAL_EXPORT vtkPowerCrust : public vtkPolyDataAlgorithm
{
public:
  static vtkPowerCrust* New();
  vtkTypeMacro(vtkPowerCrust, vtkPolyDataAlgorithm);
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
   * The axis whose balls are kept (input 1). SetInputConnection(1, ...) is the same.
   */
  void SetAxisConnection(vtkAlgorithmOutput* axis) { this->SetInputConnection(1, axis); }
  void SetAxisData(vtkDataObject* axis) { this->SetInputData(1, axis); }
  ///@}

  enum CrustRule
  {
    CLEARANCE = 0,
    INNER_ONLY = 1,
    INNER_AND_OUTER = 2
  };

  ///@{
  /**
   * What becomes of the place of removed inner balls. CLEARANCE, the default: outer balls are added
   * until no point of the crust but samples is farther from the kept balls than the clearance; none
   * that would take the topology away from that of the axis.
   * INNER_ONLY: nothing (paper 5). INNER_AND_OUTER: the outer balls of their samples go as well
   * (paper 5, for sharp corners).
   */
  vtkSetClampMacro(Rule, int, CLEARANCE, INNER_AND_OUTER);
  vtkGetMacro(Rule, int);
  void SetRuleToClearance() { this->SetRule(CLEARANCE); }
  void SetRuleToInnerOnly() { this->SetRule(INNER_ONLY); }
  void SetRuleToInnerAndOuter() { this->SetRule(INNER_AND_OUTER); }
  ///@}

  ///@{
  /**
   * How far the crust may be from the kept balls, in mean distances between neighbouring samples.
   * Greater than 0, default 1. For rule CLEARANCE.
   */
  vtkSetMacro(Clearance, double);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * How often balls are added at most. Default 10. For rule CLEARANCE.
   */
  vtkSetClampMacro(MaximumRounds, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumRounds, int);
  ///@}

protected:
  vtkPowerCrust();
  ~vtkPowerCrust() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPowerCrust(const vtkPowerCrust&) = delete;
  void operator=(const vtkPowerCrust&) = delete;

  int Rule = CLEARANCE;
  double Clearance = 1;
  int MaximumRounds = 10;

  friend class vtkSimplifyShape;
  medial::SharedBalls* Shared = nullptr; ///< set while vtkSimplifyShape works
};

#endif
