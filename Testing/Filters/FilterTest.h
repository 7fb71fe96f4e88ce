// SPDX-License-Identifier: BSD-3-Clause
#ifndef FilterTest_h
#define FilterTest_h

#include "Meshes.h"
#include "Shapes.h"

#include "vtkLocalThickness.h"
#include "vtkMedialAxis.h"
#include "vtkMedialCenterlines.h"
#include "vtkMedialPartDecomposition.h"
#include "vtkMedialPrune.h"
#include "vtkMorphometry.h"
#include "vtkPlatesAndRods.h"
#include "vtkPolarBalls.h"
#include "vtkPowerCrust.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkFieldData;
class vtkObject;
class vtkPolyData;

/// What the tests of the filters share.
namespace filterTest
{
/// Adds one to `count` for each event of an object.
void countEvents(vtkObject* sender, unsigned long event, int& count);

/// Points as a data set without cells.
vtkSmartPointer<vtkPolyData> cloud(const std::vector<medial::Point>& points);
vtkSmartPointer<vtkPolyData> dataOf(const meshes::Mesh& mesh);

/// A solid with sheets, seams, inner parts and corners, from few samples.
const shapes::Shape& smallBox();

/// The filters, connected.
struct Pipeline
{
  explicit Pipeline(vtkDataObject* samples);

  vtkNew<vtkPolarBalls> balls;
  vtkNew<vtkMedialAxis> axis;
  vtkNew<vtkMedialPartDecomposition> parts;
  vtkNew<vtkMedialPrune> prune;
  vtkNew<vtkPowerCrust> crust;
  vtkNew<vtkMorphometry> morphometry;
  vtkNew<vtkLocalThickness> thickness;
  vtkNew<vtkPlatesAndRods> elements;
  vtkNew<vtkMedialCenterlines> curves;
};

/// The pipeline of the small box, updated, the same for all tests of a program.
Pipeline& boxPipeline();

/// Collects what an object sends as errors, or as warnings, and keeps them off the screen.
class ErrorLog
{
public:
  explicit ErrorLog(vtkAlgorithm* filter, unsigned long event = vtkCommand::ErrorEvent);
  ~ErrorLog();
  const std::vector<std::string>& messages() const { return this->Messages; }

private:
  static void receive(vtkObject* sender, unsigned long event, void* log, void* message);

  vtkSmartPointer<vtkAlgorithm> Filter;
  std::vector<unsigned long> Observers;
  std::vector<std::string> Messages;
};

/// Each array as "name type components", sorted.
std::vector<std::string> arrays(vtkFieldData* data);

/// The same for the cell arrays with the measures of parts, from vtkMedialPrune's table of measures.
std::vector<std::string> measureArrays();

/// The arrays of the field data of balls that the stages after them pass on: all but the lists.
std::vector<std::string> passedOn(vtkDataObject* balls);

/// Do the two hold the same cells, points and arrays, to the last bit?
testing::AssertionResult same(vtkDataObject* a, vtkDataObject* b);

/// Neither points, cells, rows nor arrays?
testing::AssertionResult isEmpty(vtkDataObject* data);

/// All outputs empty and an error code set?
testing::AssertionResult failed(vtkAlgorithm* filter);

/// The data after a trip through VTK's XML format.
vtkSmartPointer<vtkDataObject> writtenAndRead(vtkDataObject* data);

/// A copy that can be changed.
template <typename DataSet>
vtkSmartPointer<DataSet> copy(vtkDataObject* data)
{
  auto result = vtkSmartPointer<DataSet>::New();
  result->DeepCopy(DataSet::SafeDownCast(data));
  return result;
}

/// Updates the filter and returns the one error that it must send.
std::string onlyError(vtkAlgorithm* filter);
}

#endif
