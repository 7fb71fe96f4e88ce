// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include "Canvas.h"
#include "OutputFolder.h"
#include "Scenes.h"

#include <vtkPNGWriter.h>
#include <vtkPolyData.h>

namespace
{
constexpr int PictureSize = 900;
constexpr int OverviewWidth = 500; ///< of each stage
constexpr int OverviewHeight = 560;

vtkSmartPointer<vtkActor> actorOf(
  std::size_t stage, vtkPolyData* data, const View& view, double scale)
{
  switch (stage)
  {
    case 0:
      return samplesActor(data, view.towardsViewer(), scale);
    case 1:
      return axisActor(data, scale);
    case 4:
      return surfaceActor(data);
    default:
      return partsActor(data, scale);
  }
}
}

void drawPictures(const Stages& stages, OutputFolder& folder)
{
  const View view(stages[0].data);
  for (std::size_t i = 0; i < stages.size(); ++i)
  {
    Canvas canvas(PictureSize, PictureSize);
    canvas.draw(actorOf(i, stages[i].data, view, Canvas::Oversampling), view,
      { 0, 0, PictureSize, PictureSize });
    folder.write(canvas.writer().Get(), stages[i].name + ".png");
  }
  Canvas overview(OverviewWidth * static_cast<int>(stages.size()), OverviewHeight);
  for (std::size_t i = 0; i < stages.size(); ++i)
  {
    overview.draw(actorOf(i, stages[i].data, view, 0.7 * Canvas::Oversampling), view,
      { double(i * OverviewWidth), 0, OverviewWidth, OverviewHeight }, stages[i].caption);
  }
  folder.write(overview.writer().Get(), "overview.png");
}
