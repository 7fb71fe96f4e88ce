// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTest.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLTableReader.h>
#include <vtkXMLTableWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <stdexcept>

namespace filterTest
{
namespace
{
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

AssertionResult sameTexts(vtkStringArray* a, vtkStringArray* b)
{
  if (a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return AssertionFailure() << "texts of another number";
  }
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    if (a->GetValue(i) != b->GetValue(i))
    {
      return AssertionFailure() << a->GetValue(i) << " is not " << b->GetValue(i) << " at " << i;
    }
  }
  return AssertionSuccess();
}

AssertionResult sameArray(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (vtkStringArray::SafeDownCast(a) && vtkStringArray::SafeDownCast(b))
  {
    return sameTexts(vtkStringArray::SafeDownCast(a), vtkStringArray::SafeDownCast(b));
  }
  vtkDataArray *x = vtkDataArray::SafeDownCast(a), *y = vtkDataArray::SafeDownCast(b);
  if (!x || !y || x->GetDataType() != y->GetDataType() ||
    x->GetNumberOfComponents() != y->GetNumberOfComponents() ||
    x->GetNumberOfTuples() != y->GetNumberOfTuples())
  {
    return AssertionFailure() << "arrays of another type or size";
  }
  for (vtkIdType i = 0; i < x->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < x->GetNumberOfComponents(); ++c)
    {
      const double first = x->GetComponent(i, c), second = y->GetComponent(i, c);
      if (first != second && !(std::isnan(first) && std::isnan(second)))
      {
        return AssertionFailure() << first << " is not " << second << " at " << i << ", component "
                                  << c;
      }
    }
  }
  return AssertionSuccess();
}

AssertionResult sameArrays(vtkFieldData* a, vtkFieldData* b)
{
  if (arrays(a) != arrays(b))
  {
    return AssertionFailure() << "other arrays: " << testing::PrintToString(arrays(a)) << " and "
                              << testing::PrintToString(arrays(b));
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = a->GetAbstractArray(i);
    const AssertionResult result = sameArray(array, b->GetAbstractArray(array->GetName()));
    if (!result)
    {
      return AssertionFailure() << array->GetName() << ": " << result.message();
    }
  }
  return AssertionSuccess();
}

std::vector<std::vector<vtkIdType>> corners(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> result;
  for (vtkIdType i = 0; cells && i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, size, points);
    result.emplace_back(points, points + size);
  }
  return result;
}

std::vector<std::vector<std::vector<vtkIdType>>> allCorners(vtkDataObject* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return { corners(grid->GetCells()) };
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  return { corners(surface->GetVerts()), corners(surface->GetLines()), corners(surface->GetPolys()),
    corners(surface->GetStrips()) };
}

AssertionResult sameGeometry(vtkPointSet* a, vtkPointSet* b)
{
  if (a->GetNumberOfPoints() > 0 || b->GetNumberOfPoints() > 0)
  {
    const AssertionResult points = sameArray(a->GetPoints()->GetData(), b->GetPoints()->GetData());
    if (!points)
    {
      return AssertionFailure() << "points: " << points.message();
    }
  }
  return allCorners(a) == allCorners(b) ? AssertionSuccess() : AssertionFailure() << "other cells";
}

template <typename Writer, typename Reader>
vtkSmartPointer<vtkDataObject> trip(vtkDataObject* data)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->Write();
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(writer->GetOutputString());
  reader->Update();
  return reader->GetOutputDataObject(0);
}
}

void countEvents(vtkObject* sender, unsigned long event, int& count)
{
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&count);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
  sender->AddObserver(event, counter);
}

vtkSmartPointer<vtkPolyData> cloud(const std::vector<medial::Point>& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const medial::Point& point : points)
  {
    places->InsertNextPoint(point.data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(places);
  return result;
}

vtkSmartPointer<vtkPolyData> dataOf(const meshes::Mesh& mesh)
{
  vtkNew<vtkCellArray> cells;
  for (medial::Index i = 0; i < mesh.polygons.size(); ++i)
  {
    const std::vector<vtkIdType> corners(mesh.polygons[i].begin(), mesh.polygons[i].end());
    cells->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  vtkSmartPointer<vtkPolyData> result = cloud(mesh.points);
  result->SetPolys(cells);
  return result;
}

const shapes::Shape& smallBox()
{
  static const shapes::Shape box = shapes::box(0.12);
  return box;
}

Pipeline::Pipeline(vtkDataObject* samples)
{
  this->balls->SetInputDataObject(samples);
  this->axis->SetInputConnection(this->balls->GetOutputPort());
  this->parts->SetInputConnection(this->axis->GetOutputPort());
  this->prune->SetInputConnection(this->parts->GetOutputPort());
  this->crust->SetInputConnection(this->balls->GetOutputPort());
  this->crust->SetAxisConnection(this->prune->GetOutputPort());
  this->morphometry->SetInputConnection(this->balls->GetOutputPort());
  this->morphometry->SetAxisConnection(this->prune->GetOutputPort());
  this->morphometry->SetSurfaceConnection(this->crust->GetOutputPort());
  this->thickness->SetInputConnection(this->balls->GetOutputPort());
  this->thickness->SetPlacesConnection(this->crust->GetOutputPort());
  this->thickness->SetAxisConnection(this->parts->GetOutputPort());
  this->elements->SetInputConnection(this->prune->GetOutputPort());
  this->curves->SetInputConnection(this->prune->GetOutputPort());
}

Pipeline& boxPipeline()
{
  static Pipeline pipeline(cloud(smallBox().samples));
  pipeline.morphometry->Update();
  pipeline.thickness->Update();
  pipeline.elements->Update();
  pipeline.curves->Update();
  return pipeline;
}

ErrorLog::ErrorLog(vtkAlgorithm* filter, unsigned long event)
  : Filter(filter)
{
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback(receive);
  listener->SetClientData(this);
  this->Observers.push_back(filter->AddObserver(event, listener));
  vtkNew<vtkCallbackCommand> deaf; // the executive repeats that a filter has failed
  this->Observers.push_back(filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, deaf));
}

ErrorLog::~ErrorLog()
{
  this->Filter->RemoveObserver(this->Observers[0]);
  this->Filter->GetExecutive()->RemoveObserver(this->Observers[1]);
}

void ErrorLog::receive(vtkObject*, unsigned long, void* log, void* message)
{
  static_cast<ErrorLog*>(log)->Messages.push_back(static_cast<const char*>(message));
}

std::vector<std::string> arrays(vtkFieldData* data)
{
  std::vector<std::string> result;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    result.push_back(std::string(array->GetName()) + " " + array->GetDataTypeAsString() + " " +
      std::to_string(array->GetNumberOfComponents()));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> measureArrays()
{
  std::vector<std::string> result;
  for (int i = 0; vtkMedialPrune::GetMeasureArray(i); ++i)
  {
    const bool isCount = std::string(vtkMedialPrune::GetMeasureUnit(i)) == "count";
    result.push_back(
      vtkMedialPrune::GetMeasureArray(i) + std::string(isCount ? " idtype 1" : " double 1"));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<std::string> passedOn(vtkDataObject* balls)
{
  vtkNew<vtkFieldData> rest;
  rest->ShallowCopy(balls->GetFieldData());
  for (const char* list :
    { "BallSampleOffsets", "BallSamples", "SampleInnerBall", "SampleOuterBall", "Samples" })
  {
    EXPECT_TRUE(rest->HasArray(list)) << list;
    rest->RemoveArray(list);
  }
  return arrays(rest);
}

AssertionResult same(vtkDataObject* a, vtkDataObject* b)
{
  if (std::string(a->GetClassName()) != b->GetClassName())
  {
    return AssertionFailure() << a->GetClassName() << " is not " << b->GetClassName();
  }
  for (int type = vtkDataObject::POINT; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    vtkFieldData *x = a->GetAttributesAsFieldData(type), *y = b->GetAttributesAsFieldData(type);
    const AssertionResult result = x && y ? sameArrays(x, y) : AssertionSuccess();
    if (!result)
    {
      return result;
    }
  }
  auto *x = vtkPointSet::SafeDownCast(a), *y = vtkPointSet::SafeDownCast(b);
  return x && y ? sameGeometry(x, y) : AssertionSuccess();
}

AssertionResult isEmpty(vtkDataObject* data)
{
  for (int type = vtkDataObject::POINT; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    vtkFieldData* attributes = data->GetAttributesAsFieldData(type);
    if (data->GetNumberOfElements(type) > 0 || (attributes && attributes->GetNumberOfArrays() > 0))
    {
      return AssertionFailure() << data->GetClassName() << " isn't empty";
    }
  }
  return AssertionSuccess();
}

AssertionResult failed(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    const AssertionResult empty = isEmpty(filter->GetOutputDataObject(port));
    if (!empty)
    {
      return AssertionFailure() << "port " << port << ": " << empty.message();
    }
  }
  return filter->GetErrorCode() == vtkErrorCode::UserError
    ? AssertionSuccess()
    : AssertionFailure() << "error code " << filter->GetErrorCode();
}

vtkSmartPointer<vtkDataObject> writtenAndRead(vtkDataObject* data)
{
  if (data->IsA("vtkPolyData"))
  {
    return trip<vtkXMLPolyDataWriter, vtkXMLPolyDataReader>(data);
  }
  if (data->IsA("vtkUnstructuredGrid"))
  {
    return trip<vtkXMLUnstructuredGridWriter, vtkXMLUnstructuredGridReader>(data);
  }
  if (data->IsA("vtkTable"))
  {
    return trip<vtkXMLTableWriter, vtkXMLTableReader>(data);
  }
  throw std::logic_error(std::string("no writer for ") + data->GetClassName());
}

std::string onlyError(vtkAlgorithm* filter)
{
  const ErrorLog log(filter);
  filter->Update();
  EXPECT_EQ(log.messages().size(), 1u) << testing::PrintToString(log.messages());
  EXPECT_TRUE(failed(filter));
  return log.messages().empty() ? std::string() : log.messages().front();
}
}
