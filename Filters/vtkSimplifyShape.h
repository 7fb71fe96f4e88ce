// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSimplifyShape
 * @brief   from an image, a mesh, or points of a solid's boundary, to a simplified closed surface
 *
 * The medial axis pipeline in one filter: vtkImageBoundary, vtkBoundarySamples or vtkPolarBalls, vtkMedialAxis,
 * vtkMedialPrune, vtkMedialPartDecomposition and vtkPowerCrust, one after another. The methods below set the
 * properties that are needed most often. Set the others on the stages, which belong to the filter.
 *
 * Input: vtkImageData, whose solid gets a surface by GetImageBoundary(); the properties of that filter tell
 * which voxels it has, as `GetImageBoundary()->SetSolidToIsoValue()`. Or any vtkPointSet. If it has polygons
 * that bound a solid, vtkBoundarySamples samples them and makes the balls, and everything is compared with that
 * solid. Else its points are the samples of vtkPolarBalls. SetUseTriangles() chooses.
 *
 * Output 0: vtkPolyData, the simplified surface, see vtkPowerCrust.
 * Output 1: vtkPolyData, the pruned axis with its parts, see vtkMedialPrune.
 * Output 2: vtkTable, a row for each of its parts, see vtkMedialPartDecomposition.
 * Output 3: vtkTable, a row for each iteration of the schedule, see vtkMedialPrune.
 *
 * The surface's field data has the warnings and the verdict on all stages, see vtkPolarBalls and
 * vtkPowerCrust: `Verdict` is `certified` only if all agree. Warnings of the stages are sent as warning
 * events of this filter.
 *
 * Where only the schedule or another property has changed, the balls and the axis are not made again.
 *
 * An error of a stage leaves the outputs empty and sets the error code; GetErrorMessage() tells the
 * reason. Progress counts all stages. Under MPI the piece 0 holds everything.
 *
 * See R. Tam, W. Heidrich, "Shape simplification based on the medial axis transform", IEEE
 * Visualization 2003.
 *
 * @sa vtkPolarBalls vtkMedialAxis vtkMedialPrune vtkMedialPartDecomposition vtkPowerCrust
 */

#ifndef vtkSimplifyShape_h
#define vtkSimplifyShape_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkNew.h"                 // for the stages
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the words of a schedule

namespace medial
{
struct Execution;
}
class vtkBoundarySamples;
class vtkImageBoundary;
class vtkImageData;
class vtkMedialAxis;
class vtkMedialPartDecomposition;
class vtkMedialPrune;
class vtkPolarBalls;
class vtkPointSet;
class vtkPowerCrust;
class vtkTrivialProducer;
class vtkUnstructuredGrid;

class VTKFILTERSMEDIAL_EXPORT vtkSimplifyShape : public vtkPolyDataAlgorithm
{
public:
  static vtkSimplifyShape* New();
  vtkTypeMacro(vtkSimplifyShape, vtkPolyDataAlgorithm);
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
   * The schedule of vtkMedialPrune, with the same default, "t5 t5 h0.5s a2s", and the same presets. If a word or a measure can't be
   * used, GetErrorMessage() tells why at once, and the filter fails when it runs.
   */
  void SetSchedule(const char* words);
  std::string GetScheduleWords();
  void ClearIterations();
  void AddIteration(int measure, double threshold, int passes = 0);
  void AddIterationByName(const char* measure, double threshold, int passes = 0);
  void AddIterationFromText(const char* measure, const char* threshold, const char* passes);
  ///@}

  /// What becomes of the polygons of the input.
  enum TriangleUse
  {
    AUTO = 0, ///< are sampled if they bound a solid; if they don't, a warning tells why
    ON = 1,   ///< are sampled; it is an error if they don't bound a solid
    OFF = 2   ///< make no difference; the points are the samples
  };

  ///@{
  /**
   * Sample the polygons of the input? Default AUTO.
   */
  vtkSetClampMacro(UseTriangles, int, AUTO, OFF);
  vtkGetMacro(UseTriangles, int);
  ///@}

  ///@{
  /**
   * Sample the closed surface around the polygons where they bound no solid? WrapWidth: it goes across gaps and
   * holes that are narrower, in the unit of the input; 0: a twenty-fifth of the diagonal. See
   * vtkBoundarySamples. Default off, 0.
   */
  void SetWrap(bool wrap);
  bool GetWrap();
  vtkBooleanMacro(Wrap, bool);
  void SetWrapWidth(double width);
  double GetWrapWidth();
  ///@}

  ///@{
  /**
   * Points within this distance of each other count as one where they stand apart from all others, if the
   * points are the samples; in their unit. Negative: what rounding of the input explains. See vtkPolarBalls. Default
   * -1.
   */
  void SetMergeTolerance(double tolerance);
  double GetMergeTolerance();
  ///@}

  ///@{
  /**
   * Leave out rims of the axis that small bumps of the surface make: see vtkMedialAxis. In local spacings of the
   * samples. Default 0: none.
   */
  void SetTrim(double trim);
  double GetTrim();
  ///@}

  ///@{
  /**
   * Choose the iterations from the data, instead of the schedule: see vtkMedialPrune. Default off.
   */
  void SetAutomatic(bool automatic);
  bool GetAutomatic();
  vtkBooleanMacro(Automatic, bool);
  ///@}

  ///@{
  /**
   * Cut parts at necks too, for pruning and in outputs 1 and 2, where a limb's largest radius is at
   * most NeckRatio (0 ... 1) times that of what it is cut off: see vtkMedialPartDecomposition.
   * Default off, 0.5.
   */
  void SetSplitAtNecks(bool split);
  bool GetSplitAtNecks();
  vtkBooleanMacro(SplitAtNecks, bool);
  void SetNeckRatio(double ratio);
  double GetNeckRatio();
  ///@}

  ///@{
  /**
   * Also make, for comparison, the parts of the axis before pruning and the power crust of all inner
   * balls; see GetUnprunedPartDecomposition() and GetUnprunedPowerCrust(). The axis then has `PartId`
   * when it reaches vtkMedialPrune, so that GetMedialPrune()->AddPartToRemove() can name parts by it.
   * The faces of that crust have its `PartId`. Their warnings are not told. Outputs 0 to 3 do not depend on this property. Default off.
   */
  void SetMakeUnpruned(bool make);
  vtkGetMacro(MakeUnpruned, bool);
  vtkBooleanMacro(MakeUnpruned, bool);
  ///@}

  ///@{
  /**
   * Keep the axis before pruning, and what is made of it? If not, the outputs of GetMedialAxis(),
   * GetUnprunedPartDecomposition() and GetUnprunedPowerCrust() lose all but their field data and tables when the axis
   * has been pruned, which saves up to a third of the memory; read them in the stages' EndEvent. Each
   * update then makes the axis again. Outputs 0 to 3 do not depend on this property. Default on.
   */
  vtkSetMacro(KeepAxis, bool);
  vtkGetMacro(KeepAxis, bool);
  vtkBooleanMacro(KeepAxis, bool);
  ///@}

  ///@{
  /**
   * The stages, in the order in which they run: to set their other properties and, after an update, to
   * read their outputs. Their inputs are connected already; update this filter, not the stages.
   */
  vtkImageBoundary* GetImageBoundary(); ///< runs where the input is an image
  vtkBoundarySamples*
  GetBoundarySamples();           ///< runs where polygons are sampled; makes their balls, too
  vtkPolarBalls* GetPolarBalls(); ///< runs where the points are the samples
  vtkMedialAxis* GetMedialAxis();
  vtkMedialPrune* GetMedialPrune();
  vtkMedialPartDecomposition* GetMedialPartDecomposition(); ///< of the pruned axis
  vtkPowerCrust* GetPowerCrust();                           ///< of the pruned axis
  ///@}

  ///@{
  /**
   * The additional stages that run while MakeUnpruned is on: the parts of the axis before pruning, and
   * the power crust of all inner balls.
   */
  vtkMedialPartDecomposition* GetUnprunedPartDecomposition();
  vtkPowerCrust* GetUnprunedPowerCrust();
  ///@}

  ///@{
  /**
   * The polar balls of the latest update, and its samples, as vtkPolarBalls describes them: the outputs of the stage
   * that made them.
   */
  vtkUnstructuredGrid* GetBalls();
  vtkPolyData* GetSamples();
  ///@}

  /**
   * Why the last update failed, or why AddIteration() and its like refused an iteration: the message without VTK's file, line and object. Empty if there was no error.
   */
  const char* GetErrorMessage();

  /**
   * The latest of its own and that of all stages.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkSimplifyShape();
  ~vtkSimplifyShape() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSimplifyShape(const vtkSimplifyShape&) = delete;
  void operator=(const vtkSimplifyShape&) = delete;

  vtkPointSet* MeshOf(vtkDataObject* input, const medial::Execution& execution);
  void SetInput(vtkPointSet* input);
  void TakePoints(vtkPointSet* input, const std::string& notSolid);
  void TakeBalls(vtkAlgorithmOutput* balls);
  bool TakesSamples();
  void ReadSource(vtkPointSet* input, const medial::Execution& execution);
  void PruneAxis(const medial::Execution& execution);

  int UseTriangles = AUTO;
  vtkMTimeType InputTime = 0;
  vtkMTimeType ImageTime = 0;
  bool MakeUnpruned = false;
  bool KeepAxis = true;
  std::string NotSolid;              ///< why the polygons of the input were not sampled
  vtkNew<vtkTrivialProducer> Image;  ///< the input, if it is one
  vtkNew<vtkTrivialProducer> Mesh;   ///< the input, or the surface in the image
  vtkNew<vtkTrivialProducer> Points; ///< the input with a warning, where its points are the samples
  vtkNew<vtkImageBoundary> Voxels;
  vtkNew<vtkBoundarySamples> Boundary;
  vtkNew<vtkPolarBalls> Balls;
  vtkNew<vtkMedialAxis> Axis;
  vtkNew<vtkMedialPrune> Prune;
  vtkNew<vtkMedialPartDecomposition> Parts;
  vtkNew<vtkPowerCrust> Crust;
  vtkNew<vtkMedialPartDecomposition> UnprunedParts;
  vtkNew<vtkPowerCrust> UnprunedCrust;
};

#endif
