// SPDX-License-Identifier: BSD-3-Clause
#include "Canvas.h"

#include "Errors.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double CaptionHeight = 0.09; ///< share of the area's height
constexpr double CaptionSize = 0.044;  ///< of the letters, as a share of the area's width

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

/// A text in the middle of a viewport of this size.
vtkSmartPointer<vtkTextActor> captionActor(const std::string& text, double width, double height)
{
  auto caption = vtkSmartPointer<vtkTextActor>::New();
  caption->SetInput(text.c_str());
  vtkTextProperty* style = caption->GetTextProperty();
  style->SetFontFamilyToArial();
  style->SetFontSize(static_cast<int>(std::lround(CaptionSize * width)));
  style->SetColor(0.2, 0.2, 0.2);
  style->SetJustificationToCentered();
  style->SetVerticalJustificationToCentered();
  caption->SetPosition(width / 2, height / 2);
  return caption;
}

vtkSmartPointer<vtkRenderWindow> windowOf(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width * Canvas::Oversampling, height * Canvas::Oversampling);
  return window;
}
}

View::View(vtkPolyData* object, const std::array<double, 3>& towardsViewer)
  : Direction(towardsViewer)
{
  vtkMath::Normalize(this->Direction.data());
  const bool isAlongY = std::abs(this->Direction[1]) > 0.9;
  const double upwards[3] = { 0, isAlongY ? 0.0 : 1.0, isAlongY ? 1.0 : 0.0 };
  vtkMath::Cross(upwards, this->Direction.data(), this->Right);
  vtkMath::Normalize(this->Right);
  vtkMath::Cross(this->Direction.data(), this->Right, this->Up);
  object->GetCenter(this->Center);
  this->Radius = object->GetLength() / 2;
  this->fit(object);
}

void View::apply(vtkRenderer* renderer, double aspect) const
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(this->Center);
  camera->SetPosition(this->Center[0] + 4 * this->Radius * this->Direction[0],
    this->Center[1] + 4 * this->Radius * this->Direction[1],
    this->Center[2] + 4 * this->Radius * this->Direction[2]);
  camera->SetViewUp(this->Up);
  camera->SetParallelScale(1.06 * std::max(this->HalfHeight, this->HalfWidth / aspect));
  camera->SetClippingRange(2 * this->Radius, 6 * this->Radius);
}

/// Moves the center and sets the extents so that the object just fills the view.
void View::fit(vtkPolyData* object)
{
  double lower[2] = { 0, 0 }, upper[2] = { 0, 0 };
  for (vtkIdType i = 0; i < object->GetNumberOfPoints(); ++i)
  {
    double point[3];
    object->GetPoint(i, point);
    vtkMath::Subtract(point, this->Center, point);
    const double at[2] = { vtkMath::Dot(point, this->Right), vtkMath::Dot(point, this->Up) };
    for (int k = 0; k < 2; ++k)
    {
      lower[k] = std::min(lower[k], at[k]);
      upper[k] = std::max(upper[k], at[k]);
    }
  }
  this->HalfWidth = (upper[0] - lower[0]) / 2;
  this->HalfHeight = (upper[1] - lower[1]) / 2;
  for (int k = 0; k < 3; ++k)
  {
    this->Center[k] += (lower[0] + upper[0]) / 2 * this->Right[k];
    this->Center[k] += (lower[1] + upper[1]) / 2 * this->Up[k];
  }
}

Canvas::Canvas(int width, int height)
  : Width(width)
  , Height(height)
  , Window(windowOf(width, height))
{
}

void Canvas::draw(vtkActor* actor, const View& view, const Area& area)
{
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->AutomaticLightCreationOff();
  addLight(renderer, -0.6, 0.8, 1, 0.65);
  addLight(renderer, 0.9, 0.1, 0.7, 0.35);
  view.apply(renderer, area.width / area.height);
  this->add(renderer, area);
}

void Canvas::draw(vtkActor* actor, const View& view, const Area& area, const std::string& caption)
{
  const double strip = CaptionHeight * area.height;
  this->draw(actor, view, { area.left, area.bottom + strip, area.width, area.height - strip });
  vtkNew<vtkRenderer> below;
  below->AddViewProp(captionActor(caption, Oversampling * area.width, Oversampling * strip));
  this->add(below, { area.left, area.bottom, area.width, strip });
}

void Canvas::add(vtkRenderer* renderer, const Area& area)
{
  renderer->SetBackground(1, 1, 1);
  renderer->SetViewport(area.left / this->Width, area.bottom / this->Height,
    (area.left + area.width) / this->Width, (area.bottom + area.height) / this->Height);
  this->Window->AddRenderer(renderer);
}

std::string Canvas::png(int compression)
{
  this->Window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(this->Window);
  image->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(image->GetOutputPort());
  average->SetShrinkFactors(Oversampling, Oversampling, 1);
  average->MeanOn();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(average->GetOutputPort());
  writer->SetCompressionLevel(compression);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
  {
    throw InputError("the picture can't be made");
  }
  return { bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues() };
}

void keepDisplay()
{
  static const vtkSmartPointer<vtkRenderWindow> window = windowOf(8, 8);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  window->Render();
}
