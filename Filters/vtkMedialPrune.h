// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMedialPrune
 * @brief   removes the insignificant parts of a medial axis
 *
 * Fourth filter of the medial axis pipeline. It works through a schedule of iterations. Each divides
 * the axis into parts and removes the parts of level 1 whose significance is at most a threshold,
 * least significant first. The measures of significance are those of MeasureType.
 *
 * By default pruning never changes the Betti numbers: a part may go if and only if it collapses, by
 * free faces, onto its contact with the rest.
 *
 * Passes are repeated until nothing changes. The significance of a removed part passes to its most
 * significant neighbour, if the measure adds up. So a long feature is not removed bit by bit from its
 * end. With one pass, or without topology, each part counts alone.
 *
 * Input: vtkPolyData, the output of vtkMedialAxis, vtkMedialPartDecomposition or vtkMedialPrune.
 *
 * Input 1: vtkSelection, optional: cells of input 0, or points, which stand for the cells there. The
 * parts that hold them are removed by hand or protected, see SelectionRole. Indices, values and
 * thresholds of an array, ids, locations and frusta can be used; queries can't. Ids are those of input
 * 0, as everywhere. In a collection, what was selected in one block is removed there only.
 *
 * Output 0: vtkPolyData, the living cells on all points of the input: ids of points stay. Arrays of
 * the input are passed on; the cell data of vtkMedialPartDecomposition, `PartId`, `PartRank`, `PartLevel`
 * and all measures, and the field data `NumberOfParts`, `SuggestedThreshold`, `BettiAxis`, `Certificate` are
 * those of the living cells, see there and vtkMedialAxis. `TopologyKept` is 0 unless Topology is COLLAPSE
 * here and was in all prunings before. New cell data
 *  - `KeepReason` (unsigned char): why the cell's part is still there. 0 its significance is above
 *    the last threshold, together with what went from it; 1 topology; 2 not of level 1; 3 a whole
 *    component of the axis; 4 protected.
 *  - `InputCell` (vtkIdType): the cell of the input that it is. Cells to remove and to protect, and
 *    selections, are of the input; this array leads there from cells that were chosen here.
 *
 * Output 1: vtkTable, one row for each iteration, and one more where something was removed by hand:
 * `Iteration` (vtkIdType, from 0), `Word` (string; its word in a schedule to three digits, or "by
 * hand"), `ByHand` (unsigned char), `Measure` (int; a MeasureType), `Threshold` (double), `Passes` (int;
 * made), `PartsBefore`, `PartsAfter`,
 * `Candidates` (parts of level 1 with at most the threshold; by hand: parts named), `Removed` (parts),
 * `Refused` (candidates that stayed in the last pass; the sum of `RefusedByTopology`,
 * `RefusedIsolated`, a whole piece of the axis, and `RefusedProtected`), `TopologyChanges` (removals
 * that changed the Betti numbers; -1 unless VerifyTopology is on; vtkIdType), `Betti` (vtkIdType, 3
 * components; of the axis after it), `VolumeRemoved` (double, relative).
 *
 * Output 2: vtkPolyData, the removed cells on the same points, with their arrays from the input and
 *  - `Iteration` (vtkIdType): the row of the history.
 *  - `PartId` (vtkIdType): their part in that iteration.
 *  - `PartRank` (vtkIdType): the rank that their part had before pruning.
 *  - `InputCell` (vtkIdType): the cell of the input.
 *
 * One warning lists the parts that were to be removed by hand and were not, with the reason: needed
 * for the topology, a whole piece of the axis, protected, or already gone.
 *
 * Pruning again with another threshold takes a fraction of the time. For that the filter keeps a copy of
 * the axis, what it has derived from it, and what went when: about 200 bytes for each cell, until it
 * runs on an input that has changed. Iterations at the beginning of the schedule that are the same as
 * in the last run are not made again, but for the last one of the schedule. If you change values of an
 * array in place, call its Modified().
 *
 * An error (an array that is missing or does not fit; a negative threshold; a part or cell to remove
 * or to protect that isn't there; a selection that can't be used) leaves the outputs empty and sets
 * the error code. Under MPI the piece 0 holds everything.
 *
 * See R. Tam, W. Heidrich, "Shape simplification based on the medial axis transform", IEEE
 * Visualization 2003, sections 4.2, 4.3 and 6.
 *
 * @sa vtkMedialPartDecomposition vtkPowerCrust
 */

#ifndef vtkMedialPrune_h
#define vtkMedialPrune_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class VTKFILTERSMEDIAL_EXPORT vtkMedialPrune : public vtkPolyDataAlgorithm
{
public:
  static vtkMedialPrune* New();
  vtkTypeMacro(vtkMedialPrune, vtkPolyDataAlgorithm);
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
   * What makes a part significant, with the unit of its thresholds; see GetMeasureUnit and
   * GetMeasureDescription, and Core/Parts/Measures.h for the formulas.
   */
  enum MeasureType
  {
    TRIANGLE_COUNT = 0,       ///< triangles, lines or vertices
    RELATIVE_VOLUME = 1,      ///< share of the solid's volume, 0 ... 1
    RELATIVE_POLE_VOLUME = 2, ///< the same of its poles alone, the paper's literal definition
    AREA = 3,                 ///< of its triangles; square of the samples' unit; curves stay
    MEAN_RADIUS = 4,          ///< of the maximal balls at its points; length
    MAXIMUM_RADIUS = 5,       ///< of the maximal balls at its points; length
    OBJECT_ANGLE = 6,         ///< mean angle at which a cell sees its two sites; 0 ... 180 degrees
    LAMBDA = 7,               ///< largest distance of two sites of a cell; length
    EROSION_THICKNESS = 8,    ///< burn time minus radius; length
    HAUSDORFF_DISTANCE = 9,   ///< how far the solid recedes, at most; length
    BOUNDARY_LENGTH = 10      ///< of its free border; length
  };

  ///@{
  /**
   * The schedule in words, one for each iteration: a letter for the measure and the threshold, such as
   * "t5 t5 h0.5s a2s", the default: twice parts of at most 5 triangles, then parts without which the
   * solid recedes by at most half a sample spacing, then parts of at most two square spacings.
   * GetMeasureWord tells the word of each measure. Volumes are in per cent (v1%). Lengths are in the unit
   * of the samples (r0.5), in mean sample spacings (r2s), or in per cent of the diagonal of the samples'
   * bounding box (r2%); areas in the square of the unit (a0.5) or of the spacing (a2s). x and a number at
   * the end of a word limit its passes: t5x1. No words: no iterations. The name of a preset stands for
   * its words, see GetPresetName.
   * A word that can't be read is an error, here and whenever the filter runs by this schedule.
   * GetScheduleWords returns words that give the same schedule again.
   */
  void SetSchedule(const char* words);
  std::string GetScheduleWords() const;
  ///@}

  ///@{
  /**
   * Schedules with names: 0 is the default, "noise"; then "details", "features", "skeleton" and "paper".
   * Their words, and what they remove. Null where there is no such preset.
   */
  static const char* GetPresetName(int preset);
  static const char* GetPresetWords(int preset);
  static const char* GetPresetDescription(int preset);
  ///@}

  ///@{
  /**
   * The same one iteration after another. An iteration removes parts whose measure is at most the
   * threshold, and repeats that `passes` times, or until nothing changes where passes is 0. Thresholds
   * are in the unit of the measure, shares of the volume 0 ... 1. Clear the default schedule before
   * adding your own iterations. A measure that there isn't, a threshold that is negative, not finite or
   * above what the unit allows (a share above 1, an angle above 180), and a negative number of passes
   * are errors, here and whenever the filter runs by this schedule.
   */
  void ClearIterations();
  void AddIteration(int measure, double threshold, int passes = 0);
  int GetNumberOfIterations() const;
  ///@}

  ///@{
  /**
   * The name of a MeasureType, which is its column in the table of parts; its array on the cells of the
   * parts; its unit; what it is in a few words; and how its words in a schedule
   * are written, as tN, vP% or rX. Null or empty where there is no such measure.
   */
  static const char* GetMeasureName(int measure);
  static const char* GetMeasureArray(int measure);
  static const char* GetMeasureUnit(int measure);
  static const char* GetMeasureDescription(int measure);
  static std::string GetMeasureWord(int measure);
  ///@}

  /**
   * AddIteration for a measure by its name.
   */
  void AddIterationByName(const char* measure, double threshold, int passes = 0);

  ///@{
  /**
   * The same from what people type: a threshold such as 0.05 or 5e-2, a whole number of passes. The
   * threshold of a length may end with s or %: 1s is one mean sample spacing, 2% is of the diagonal; that
   * of an area with s: 2s is two square spacings.
   * Other texts, such as "0,05" or none, are an error; they are never taken for another number.
   * GetIterationFault tells, without an iteration, what is wrong with one in three texts; "": nothing.
   */
  void AddIterationFromText(const char* measure, const char* threshold, const char* passes);
  static std::string GetIterationFault(
    const char* measure, const char* threshold, const char* passes);
  ///@}

  ///@{
  /**
   * One iteration of the schedule, 0 ... GetNumberOfIterations() - 1; 0 where there is none. The
   * threshold is in the unit of its word in GetScheduleWords, but not in per cent.
   */
  int GetIterationMeasure(int iteration) const;
  double GetIterationThreshold(int iteration) const;
  int GetIterationPasses(int iteration) const;
  ///@}

  ///@{
  /**
   * Choose the iterations from the data, instead of the schedule: TRIANGLE_COUNT up to 5 until an
   * iteration removes less than a tenth of the parts, then RELATIVE_VOLUME up to the largest gap in
   * log-significance (see `SuggestedThreshold`), again until less than a tenth of the parts goes or a
   * tenth of the volume is gone. The history tells what was chosen. Default off.
   */
  vtkSetMacro(Automatic, bool);
  vtkGetMacro(Automatic, bool);
  vtkBooleanMacro(Automatic, bool);
  ///@}

  ///@{
  /**
   * Cut parts at necks too: limbs that the paper's parts leave on the rest, as a bunny's feet, become
   * parts of their own. The necks are those of the input. A limb's largest radius is at most NeckRatio
   * times that of what it is cut off; see Core/Parts/Necks.h. Prune noise away first. Default off, 0.5.
   */
  vtkSetMacro(SplitAtNecks, bool);
  vtkGetMacro(SplitAtNecks, bool);
  vtkBooleanMacro(SplitAtNecks, bool);
  vtkSetClampMacro(NeckRatio, double, 0, 1);
  vtkGetMacro(NeckRatio, double);
  ///@}

  enum TopologyMode
  {
    COLLAPSE = 0,
    NONE = 1,
    PAPER_GRAPH = 2
  };

  ///@{
  /**
   * Which removals are allowed: those that keep the Betti numbers (COLLAPSE, the default), that of
   * every part of level 1 (NONE), or those that the paper's topology graph allows (PAPER_GRAPH, for
   * comparison): of parts that touch one of its nodes. The graph does not see a loop inside a part,
   * nor what parts hold together in points and by lines, so it loses loops and tears pieces off.
   */
  vtkSetClampMacro(Topology, int, COLLAPSE, PAPER_GRAPH);
  vtkGetMacro(Topology, int);
  void SetTopologyToCollapse() { this->SetTopology(COLLAPSE); }
  void SetTopologyToNone() { this->SetTopology(NONE); }
  void SetTopologyToPaperGraph() { this->SetTopology(PAPER_GRAPH); }
  ///@}

  ///@{
  /**
   * Compute the Betti numbers anew after every single removal. With COLLAPSE a change is an error (a
   * bug of ours), else it counts as `TopologyChanges` in the history. Slow: for tests. Default off.
   */
  vtkSetMacro(VerifyTopology, bool);
  vtkGetMacro(VerifyTopology, bool);
  vtkBooleanMacro(VerifyTopology, bool);
  ///@}

  ///@{
  /**
   * In each pass remove chains of lines with a free end first, where they have at most the threshold;
   * a line counts like a triangle. Default on.
   */
  vtkSetMacro(RemoveHair, bool);
  vtkGetMacro(RemoveHair, bool);
  vtkBooleanMacro(RemoveHair, bool);
  ///@}

  ///@{
  /**
   * Remove a part together with a smaller rest that it alone connects, where their summed
   * significance is at most the threshold. Default on.
   */
  vtkSetMacro(RemoveBranches, bool);
  vtkGetMacro(RemoveBranches, bool);
  vtkBooleanMacro(RemoveBranches, bool);
  ///@}

  ///@{
  /**
   * Parts to remove after the schedule, however significant: numbers in the array `PartId` of the
   * input. Every part then living that holds a cell of theirs goes, where topology lets it. Default:
   * none.
   */
  void ClearPartsToRemove();
  void AddPartToRemove(vtkIdType part);
  vtkIdType GetNumberOfPartsToRemove() const;
  ///@}

  ///@{
  /**
   * The same by cells of the input. Default: none.
   */
  void ClearCellsToRemove();
  void AddCellToRemove(vtkIdType cell);
  vtkIdType GetNumberOfCellsToRemove() const;
  ///@}

  ///@{
  /**
   * Parts and cells that stay, by the same numbers: no part that holds a cell of theirs ever goes,
   * neither alone nor with a branch, nor by hand. Default: none.
   */
  void ClearPartsToProtect();
  void AddPartToProtect(vtkIdType part);
  vtkIdType GetNumberOfPartsToProtect() const;
  void ClearCellsToProtect();
  void AddCellToProtect(vtkIdType cell);
  vtkIdType GetNumberOfCellsToProtect() const;
  ///@}

  enum SelectionRoleType
  {
    REMOVE = 0,
    PROTECT = 1
  };

  ///@{
  /**
   * What happens to the parts that the selection of input 1 names: removed after the schedule
   * (REMOVE, the default) or protected.
   */
  vtkSetClampMacro(SelectionRole, int, REMOVE, PROTECT);
  vtkGetMacro(SelectionRole, int);
  void SetSelectionRoleToRemove() { this->SetSelectionRole(REMOVE); }
  void SetSelectionRoleToProtect() { this->SetSelectionRole(PROTECT); }
  ///@}

  /**
   * Connects input 1, the selection.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* selection)
  {
    this->SetInputConnection(1, selection);
  }

protected:
  vtkMedialPrune();
  ~vtkMedialPrune() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMedialPrune(const vtkMedialPrune&) = delete;
  void operator=(const vtkMedialPrune&) = delete;

  void RefuseSchedule(const std::string& fault);

  friend class vtkSimplifyShape;
  void ForgetAxis(); ///< that is kept for the next threshold

  struct vtkLists;
  struct vtkAxis;
  std::unique_ptr<vtkLists> Lists;
  std::unique_ptr<vtkAxis> Axis;
  int Topology = COLLAPSE;
  bool RemoveHair = true;
  bool RemoveBranches = true;
  bool VerifyTopology = false;
  bool Automatic = false;
  bool SplitAtNecks = false;
  double NeckRatio = 0.5;
  int SelectionRole = REMOVE;
};

#endif
