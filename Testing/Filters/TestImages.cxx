// SPDX-License-Identifier: BSD-3-Clause
// Draws what one filter makes of the box and compares it with Baseline/. Without a display there is
// nothing to draw on, and VTK would end the process: exit 77 then, which is "skipped" for CTest.
// After a wanted change look at the new picture, in Testing/Filters of the build folder, and copy it.
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

/// Cells in the colours of their levels: closed sheets grey, the border blue, inner parts orange.
vtkSmartPointer<vtkActor> byLevel(vtkAlgorithm* filter)
{
  vtkNew<vtkLookupTable> colors;
  colors->SetNumberOfTableValues(3);
  colors->SetTableValue(0, 0.7, 0.7, 0.7);
  colors->SetTableValue(1, 0.3, 0.6, 0.9);
  colors->SetTableValue(2, 1, 0.6, 0.2);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(filter->GetOutputPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("PartLevel");
  mapper->SetLookupTable(colors);
  mapper->SetScalarRange(0, 2);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> inOneColor(vtkAlgorithmOutput* output, double r, double g, double b)
{
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
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
  vtkSmartPointer<vtkActor> actor = inOneColor(boxPipeline().crust->GetOutputPort(), 0.9, 0.8, 0.6);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->BackfaceCullingOn(); // wrongly oriented faces would be holes
  return actor;
}

std::vector<vtkSmartPointer<vtkActor>> picture(const std::string& stage)
{
  if (stage == "vtkPolarBalls")
  {
    return { innerBalls() };
  }
  if (stage == "vtkMedialAxis")
  {
    return { axisByRadius() };
  }
  if (stage == "vtkMedialPartDecomposition")
  {
    return { byLevel(boxPipeline().parts) };
  }
  if (stage == "vtkMedialPrune")
  {
    return { byLevel(boxPipeline().prune),
      inOneColor(boxPipeline().prune->GetOutputPort(2), 0.9, 0.1, 0.1) };
  }
  return { crust() };
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
  for (vtkActor* actor : picture(stage))
  {
    actor->GetProperty()->SetAmbient(0.35); // the axis shows its dark sides as well
    actor->GetProperty()->SetDiffuse(0.65);
    renderer->AddActor(actor);
  }
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
  renderer->GetActiveCamera()->Zoom(1.2);
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
