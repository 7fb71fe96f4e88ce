// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include "Errors.h"
#include "OutputFolder.h"
#include "Scenes.h"

#include <vtkCamera.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
/// Pictures are drawn this many times too large and averaged, which smooths every edge.
constexpr int Oversampling = 2;
constexpr int PictureSize = 900;
constexpr int OverviewWidth = 500; ///< of each stage
constexpr int OverviewHeight = 560;
constexpr double CaptionHeight = 0.09; ///< share of the overview's height

/// A parallel view from the front, from somewhat above and aside, that holds all samples.
struct View
{
  double direction[3] = { 0.35, 0.25, 1 }; ///< from the object to the camera
  double right[3], up[3];
  double center[3];
  double halfWidth = 0, halfHeight = 0, radius = 0;

  explicit View(vtkPolyData* samples)
  {
    const double y[3] = { 0, 1, 0 };
    vtkMath::Normalize(this->direction);
    vtkMath::Cross(y, this->direction, this->right);
    vtkMath::Normalize(this->right);
    vtkMath::Cross(this->direction, this->right, this->up);
    samples->GetCenter(this->center);
    this->radius = samples->GetLength() / 2;
    this->fit(samples);
  }

  /// The camera for a viewport of this width / height.
  void apply(vtkRenderer* renderer, double aspect) const
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(this->center);
    camera->SetPosition(this->center[0] + 4 * this->radius * this->direction[0],
      this->center[1] + 4 * this->radius * this->direction[1],
      this->center[2] + 4 * this->radius * this->direction[2]);
    camera->SetViewUp(this->up);
    camera->SetParallelScale(1.06 * std::max(this->halfHeight, this->halfWidth / aspect));
    camera->SetClippingRange(2 * this->radius, 6 * this->radius);
  }

private:
  /// Moves the centre and sets the extents so that the samples just fill the view.
  void fit(vtkPolyData* samples)
  {
    double lower[2] = { 0, 0 }, upper[2] = { 0, 0 };
    for (vtkIdType i = 0; i < samples->GetNumberOfPoints(); ++i)
    {
      double point[3];
      samples->GetPoint(i, point);
      vtkMath::Subtract(point, this->center, point);
      const double at[2] = { vtkMath::Dot(point, this->right), vtkMath::Dot(point, this->up) };
      for (int k = 0; k < 2; ++k)
      {
        lower[k] = std::min(lower[k], at[k]);
        upper[k] = std::max(upper[k], at[k]);
      }
    }
    this->halfWidth = (upper[0] - lower[0]) / 2;
    this->halfHeight = (upper[1] - lower[1]) / 2;
    for (int k = 0; k < 3; ++k)
    {
      this->center[k] += (lower[0] + upper[0]) / 2 * this->right[k];
      this->center[k] += (lower[1] + upper[1]) / 2 * this->up[k];
    }
  }
};

/// A light fixed to the camera, at (right, up, towards the viewer).
void addLight(vtkRenderer* renderer, double right, double up, double front, double intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(right, up, front);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

vtkSmartPointer<vtkActor> actorOf(
  std::size_t stage, vtkPolyData* data, const View& view, double scale)
{
  switch (stage)
  {
    case 0:
      return samplesActor(data, view.direction, scale);
    case 1:
      return axisActor(data, scale);
    case 4:
      return surfaceActor(data);
    default:
      return partsActor(data, scale);
  }
}

/// A white renderer with one stage in it, for a viewport of this width / height.
vtkSmartPointer<vtkRenderer> rendererOf(
  std::size_t stage, vtkPolyData* data, const View& view, double aspect, double scale)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(actorOf(stage, data, view, scale));
  renderer->AutomaticLightCreationOff();
  addLight(renderer, -0.6, 0.8, 1, 0.65);
  addLight(renderer, 0.9, 0.1, 0.7, 0.35);
  view.apply(renderer, aspect);
  return renderer;
}

vtkSmartPointer<vtkTextActor> captionActor(const std::string& text, int width)
{
  auto caption = vtkSmartPointer<vtkTextActor>::New();
  caption->SetInput(text.c_str());
  vtkTextProperty* style = caption->GetTextProperty();
  style->SetFontFamilyToArial();
  style->SetFontSize(22 * Oversampling);
  style->SetColor(0.2, 0.2, 0.2);
  style->SetJustificationToCentered();
  style->SetVerticalJustificationToCentered();
  caption->SetPosition(
    width * Oversampling / 2.0, OverviewHeight * Oversampling * CaptionHeight / 2);
  return caption;
}

vtkSmartPointer<vtkRenderWindow> windowOf(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width * Oversampling, height * Oversampling);
  return window;
}

void writePicture(vtkRenderWindow* window, const std::string& name, OutputFolder& folder)
{
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(image->GetOutputPort());
  average->SetShrinkFactors(Oversampling, Oversampling, 1);
  average->MeanOn();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(average->GetOutputPort());
  folder.write(writer.Get(), name + ".png");
}

void drawOverview(const Stages& stages, const View& view, OutputFolder& folder)
{
  const double aspect = OverviewWidth / (OverviewHeight * (1 - CaptionHeight));
  auto window = windowOf(OverviewWidth * static_cast<int>(stages.size()), OverviewHeight);
  for (std::size_t i = 0; i < stages.size(); ++i)
  {
    const double left = double(i) / stages.size();
    const double right = double(i + 1) / stages.size();
    auto scene = rendererOf(i, stages[i].data, view, aspect, 0.7 * Oversampling);
    scene->SetViewport(left, CaptionHeight, right, 1);
    window->AddRenderer(scene);
    vtkNew<vtkRenderer> below;
    below->SetBackground(1, 1, 1);
    below->SetViewport(left, 0, right, CaptionHeight);
    below->AddActor2D(captionActor(stages[i].caption, OverviewWidth));
    window->AddRenderer(below);
  }
  writePicture(window, "overview", folder);
}

/// Opens a window in a child process, where VTK may abort. True if it didn't.
bool canOpenWindow()
{
  const pid_t child = fork();
  if (child == 0)
  {
    const bool silent = std::freopen("/dev/null", "w", stderr) != nullptr;
    vtkNew<vtkRenderer> renderer;
    auto window = windowOf(8, 8);
    window->AddRenderer(renderer);
    window->Render();
    std::_Exit(silent ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  int status = 0;
  return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
    WEXITSTATUS(status) == EXIT_SUCCESS;
}
}

void checkDisplay()
{
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    throw UsageError("--picture needs an X server, but DISPLAY is not set; use Examples/run, which "
                     "starts one, or xvfb-run");
  }
  if (!canOpenWindow())
  {
    throw UsageError(std::string("--picture needs an X server with OpenGL, but none answers at "
                                 "DISPLAY=") +
      display + "; use Examples/run, which starts one, or xvfb-run");
  }
}

void drawPictures(const Stages& stages, OutputFolder& folder)
{
  const View view(stages[0].data);
  for (std::size_t i = 0; i < stages.size(); ++i)
  {
    auto scene = rendererOf(i, stages[i].data, view, 1, Oversampling);
    auto window = windowOf(PictureSize, PictureSize);
    window->AddRenderer(scene);
    writePicture(window, stages[i].name, folder);
  }
  drawOverview(stages, view, folder);
}
