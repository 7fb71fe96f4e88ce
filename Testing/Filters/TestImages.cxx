// SPDX-License-Identifier: BSD-3-Clause
// Draws what one filter makes of the box and compares it with Baseline/. Without a display there is
// nothing to draw on, and VTK would end the process: exit 77 then, which is "skipped" for CTest.
#include "FilterTest.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataSetMapper.h>
#include <vtkGlyph3DMapper.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTesting.h>
#include <vtkThresholdPoints.h>
#include <vtkUnstructuredGrid.h>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

namespace
{
using filterTest::boxPipeline;

/// Colours that tell neighbouring numbers apart.
vtkSmartPointer<vtkLookupTable> distinctColors()
{
  auto colors = vtkSmartPointer<vtkLookupTable>::New();
  colors->SetNumberOfTableValues(17);
  for (vtkIdType i = 0; i < 17; ++i)
  {
    const double turn = static_cast<double>(i * 5 % 17) / 17;
    colors->SetTableValue(i, 0.5 + 0.5 * std::cos(6.28 * turn),
      0.5 + 0.5 * std::cos(6.28 * turn + 2), 0.5 + 0.5 * std::cos(6.28 * turn + 4));
  }
  colors->SetIndexedLookup(0);
  return colors;
}

/// Cells in the colours of their parts.
vtkSmartPointer<vtkActor> byPart(vtkAlgorithm* filter)
{
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(filter->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("PartId");
  vtkSmartPointer<vtkLookupTable> colors = distinctColors();
  mapper->SetLookupTable(colors);
  mapper->SetScalarRange(0, 16);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> innerBalls()
{
  vtkNew<vtkThresholdPoints> inner;
  inner->SetInputConnection(boxPipeline().balls->GetOutputPort());
  inner->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Side");
  inner->ThresholdBetween(1, 1);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1);
  ball->SetThetaResolution(24);
  ball->SetPhiResolution(24);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(inner->GetOutputPort());
  mapper->SetSourceConnection(ball->GetOutputPort());
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleArray("Radius");
  mapper->SetScaleFactor(1);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.5, 0.7, 0.9);
  return actor;
}

vtkSmartPointer<vtkActor> axisByRadius()
{
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(boxPipeline().axis->GetOutputPort());
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("Radius");
  mapper->SetScalarRange(0, 0.5);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->EdgeVisibilityOn();
  actor->GetProperty()->SetEdgeColor(0.3, 0.3, 0.3);
  return actor;
}

vtkSmartPointer<vtkActor> crust()
{
  vtkSmartPointer<vtkActor> actor = byPart(boxPipeline().crust);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->BackfaceCullingOn(); // wrongly oriented faces would be holes
  return actor;
}

vtkSmartPointer<vtkActor> picture(const std::string& stage)
{
  return stage == "vtkPolarBalls"           ? innerBalls()
    : stage == "vtkMedialAxis"              ? axisByRadius()
    : stage == "vtkMedialPartDecomposition" ? byPart(boxPipeline().parts)
    : stage == "vtkMedialPrune"             ? byPart(boxPipeline().prune)
                                            : crust();
}
}

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: TestImages FILTER BASELINE_FOLDER OUTPUT_FOLDER\n";
    return 1;
  }
  if (!std::getenv("DISPLAY"))
  {
    std::cout << "no display\n";
    return 77;
  }
  const std::string stage = argv[1];
  boxPipeline();
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkActor> actor = picture(stage);
  actor->GetProperty()->SetAmbient(0.35); // the axis shows its dark sides as well
  actor->GetProperty()->SetDiffuse(0.65);
  renderer->AddActor(actor);
  renderer->SetBackground(1, 1, 1);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetOffScreenRendering(true);
  window->SetSize(300, 220);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->ParallelProjectionOn();
  renderer->GetActiveCamera()->SetPosition(2, -4, 2.5);
  renderer->GetActiveCamera()->SetFocalPoint(0, 0, 0);
  renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.4);
  window->Render();

  const double allowedDifference = 10; // VTK's measure; another driver's edges stay far below it
  vtkNew<vtkTesting> testing;
  const std::string baseline = std::string(argv[2]) + "/" + stage + ".png";
  for (const char* argument : { "-T", static_cast<const char*>(argv[3]), "-V", baseline.c_str() })
  {
    testing->AddArgument(argument);
  }
  testing->SetRenderWindow(window);
  return testing->RegressionTest(allowedDifference) == vtkTesting::PASSED ? 0 : 1;
}
