// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include "Canvas.h"
#include "DurableFiles.h"
#include "Errors.h"
#include "Scenes.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace
{
constexpr std::array<const char*, 5> StageNames = { "samples", "axis", "parts", "pruned",
  "surface" };
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

vtkSmartPointer<vtkPolyData> read(const fs::path& file)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw InputError(file.string() + ": can't be read");
  }
  return reader->GetOutput();
}

void write(Canvas& canvas, const fs::path& file)
{
  try
  {
    writeFile(file, canvas.png(5));
  }
  catch (const std::system_error& error)
  {
    throw InputError(file.filename().string() + ": can't be written: " + error.code().message());
  }
}

struct Order
{
  fs::path results, target;
  Captions captions;
};

/// Paths and captions end with a zero, which occurs in none of them.
Order parseOrder(const std::string& text)
{
  std::vector<std::string> pieces;
  for (std::size_t begin = 0, end; (end = text.find('\0', begin)) != std::string::npos;
       begin = end + 1)
  {
    pieces.push_back(text.substr(begin, end - begin));
  }
  Order order = { pieces.at(0), pieces.at(1), {} };
  for (std::size_t i = 0; i < order.captions.size(); ++i)
  {
    order.captions[i] = pieces.at(2 + i);
  }
  return order;
}
}

std::string pictureOrder(const fs::path& results, const fs::path& target, const Captions& captions)
{
  std::string text = results.string() + '\0' + target.string() + '\0';
  for (const std::string& caption : captions)
  {
    text += caption + '\0';
  }
  return text;
}

void drawPictures(const std::string& text)
{
  const Order order = parseOrder(text);
  std::array<vtkSmartPointer<vtkPolyData>, StageNames.size()> data;
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    data[i] = read(order.results / (StageNames[i] + std::string(".vtp")));
  }
  const View view(data[0]);
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    Canvas canvas(PictureSize, PictureSize);
    canvas.draw(
      actorOf(i, data[i], view, Canvas::Oversampling), view, { 0, 0, PictureSize, PictureSize });
    write(canvas, order.target / (StageNames[i] + std::string(".png")));
  }
  Canvas overview(OverviewWidth * static_cast<int>(data.size()), OverviewHeight);
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    overview.draw(actorOf(i, data[i], view, 0.7 * Canvas::Oversampling), view,
      { double(i * OverviewWidth), 0, OverviewWidth, OverviewHeight }, order.captions[i]);
  }
  write(overview, order.target / "overview.png");
}
