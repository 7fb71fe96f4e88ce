// SPDX-License-Identifier: BSD-3-Clause
#include "PagePictures.h"

#include "Canvas.h"
#include "DurableFiles.h"
#include "Json.h"
#include "Lines.h"
#include "Pictures.h"
#include "Scenes.h"
#include "ThicknessMap.h"

#include <vtkNew.h>
#include <vtkXMLPolyDataWriter.h>

namespace fs = std::filesystem;

namespace
{
constexpr int Size = 760;

void draw(vtkActor* actor, const View& view, const fs::path& file)
{
  Canvas canvas(Size, Size);
  canvas.draw(actor, view, { 0, 0, Size, Size });
  writePicture(canvas, file);
}
}

std::string pagePictureOrder(
  const fs::path& results, const fs::path& scratch, const ThicknessMap& map)
{
  vtkNew<vtkXMLPolyDataWriter> writer; // into memory, see OutputFolder
  writer->SetInputData(map.axis);
  writer->SetDataModeToBinary();
  writer->WriteToOutputStringOn();
  writer->Write();
  writeFile(scratch / "axis.vtp", writer->GetOutputString());
  return orderOf({ results.string(), scratch.string(), number(map.top()) });
}

void drawPagePictures(const std::string& order)
{
  const std::vector<std::string> pieces = piecesOf(order);
  const fs::path results = pieces.at(0), scratch = pieces.at(1);
  const double top = std::stod(pieces.at(2));
  const auto surface = readPolyData(results / "thickness.vtp");
  const View view(surface);
  draw(thickSurfaceActor(surface, top), view, scratch / "surface.png");
  draw(thickAxisActor(readPolyData(scratch / "axis.vtp"), top, Canvas::Oversampling), view,
    scratch / "axis.png");
  draw(partsActor(readPolyData(results / "pruned.vtp"), Canvas::Oversampling), view,
    scratch / "parts.png");
}

PagePictures drawnPagePictures(const fs::path& scratch)
{
  const auto picture = [&](const char* name) { return contentOf((scratch / name).string()); };
  return { picture("surface.png"), picture("axis.png"), picture("parts.png"), "" };
}
