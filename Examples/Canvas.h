// SPDX-License-Identifier: BSD-3-Clause
#ifndef Canvas_h
#define Canvas_h

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

/// A parallel view that just holds all points of an object.
class View
{
public:
  /// @param towardsViewer  direction from the object to the viewer, of any length. Up is y, or z if the
  ///                       direction is near y.
  explicit View(
    vtkPolyData* object, const std::array<double, 3>& towardsViewer = { 0.35, 0.25, 1 });

  /// From the object to the viewer, of length 1.
  const double* towardsViewer() const { return this->Direction.data(); }

  /// Sets the camera for a viewport of this width / height.
  void apply(vtkRenderer* renderer, double aspect) const;

private:
  void fit(vtkPolyData* object);

  std::array<double, 3> Direction; ///< of length 1
  double Right[3], Up[3];
  double Center[3];
  double HalfWidth = 0, HalfHeight = 0, Radius = 0;
};

/// A white picture in which objects are drawn side by side.
class Canvas
{
public:
  /// Pictures are drawn this many times too large and averaged, which smooths every edge. Widths of
  /// lines and sizes of dots are in pixels of the larger picture.
  static constexpr int Oversampling = 2;

  /// @param width, height  in pixels
  Canvas(int width, int height);

  /// A rectangle of the picture, in pixels from its lower left corner.
  struct Area
  {
    double left, bottom, width, height;
  };

  /// Draws an object into an area.
  void draw(vtkActor* actor, const View& view, const Area& area);

  /// Draws an object and, in a strip at the bottom of the area, a caption.
  void draw(vtkActor* actor, const View& view, const Area& area, const std::string& caption);

  /// The picture as it is now, as the content of a .png file.
  /// @param compression  0 is fast, 9 makes small files
  /// @throw InputError  it can't be made
  std::string png(int compression);

private:
  void add(vtkRenderer* renderer, const Area& area);

  int Width, Height;
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// Connects to the X server until the process ends. Without one VTK aborts the process, see
/// DrawingProcess.h.
void keepDisplay();

#endif
