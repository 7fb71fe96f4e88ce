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

struct Order
{
  fs::path results, target;
  Captions captions;
};

Order parseOrder(const std::string& text)
{
  const std::vector<std::string> pieces = piecesOf(text);
  Order order = { pieces.at(0), pieces.at(1), {} };
  for (std::size_t i = 0; i < order.captions.size(); ++i)
  {
    order.captions[i] = pieces.at(2 + i);
  }
  return order;
}
}

std::string orderOf(const std::vector<std::string>& pieces)
{
  std::string text;
  for (const std::string& piece : pieces)
  {
    text += piece + '\0';
  }
  return text;
}

std::vector<std::string> piecesOf(const std::string& order)
{
  std::vector<std::string> pieces;
  for (std::size_t begin = 0, end; (end = order.find('\0', begin)) != std::string::npos;
       begin = end + 1)
  {
    pieces.push_back(order.substr(begin, end - begin));
  }
  return pieces;
}

vtkSmartPointer<vtkPolyData> readPolyData(const fs::path& file)
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

void writePicture(Canvas& canvas, const fs::path& file)
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

std::string pictureOrder(const fs::path& results, const fs::path& target, const Captions& captions)
{
  std::vector<std::string> pieces = { results.string(), target.string() };
  pieces.insert(pieces.end(), captions.begin(), captions.end());
  return orderOf(pieces);
}

void drawPictures(const std::string& text)
{
  const Order order = parseOrder(text);
  std::array<vtkSmartPointer<vtkPolyData>, StageNames.size()> data;
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    data[i] = readPolyData(order.results / (StageNames[i] + std::string(".vtp")));
  }
  const View view(data[0]);
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    Canvas canvas(PictureSize, PictureSize);
    canvas.draw(
      actorOf(i, data[i], view, Canvas::Oversampling), view, { 0, 0, PictureSize, PictureSize });
    writePicture(canvas, order.target / (StageNames[i] + std::string(".png")));
  }
  Canvas overview(OverviewWidth * static_cast<int>(data.size()), OverviewHeight);
  for (std::size_t i = 0; i < data.size(); ++i)
  {
    overview.draw(actorOf(i, data[i], view, 0.7 * Canvas::Oversampling), view,
      { double(i * OverviewWidth), 0, OverviewWidth, OverviewHeight }, order.captions[i]);
  }
  writePicture(overview, order.target / "overview.png");
}
