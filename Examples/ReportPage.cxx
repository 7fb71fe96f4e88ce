// SPDX-License-Identifier: BSD-3-Clause
#include "ReportPage.h"

#include "Errors.h"
#include "OutputFolder.h"
#include "Page.h"
#include "PagePictures.h"
#include "ThicknessMap.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <exception>
#include <iostream>

ReportPage::ReportPage()
{
  try
  {
    this->Drawing.emplace("a picture", drawPagePictures);
  }
  catch (const UsageError& error)
  {
    this->Missing = error.what();
  }
}

/// What can't be drawn is told on the page; the results are worth more than the pictures.
PagePictures ReportPage::pictures(const ThicknessMap& map, OutputFolder& folder)
{
  PagePictures result;
  result.missing = this->Missing;
  try
  {
    if (this->Drawing)
    {
      const std::filesystem::path scratch = folder.scratch();
      this->Drawing->draw(pagePictureOrder(folder.draft(), scratch, map));
      result = drawnPagePictures(scratch);
    }
  }
  catch (const std::exception& error)
  {
    result.missing = error.what();
  }
  if (!result.missing.empty())
  {
    std::cerr << "warning: report.html has no pictures: " << result.missing << '\n';
  }
  return result;
}

void ReportPage::write(vtkSimplifyShape* simplify, const PageHead& head, vtkTable* means,
  Progress& progress, OutputFolder& folder)
{
  const ThicknessMap map = thicknessMap(simplify, means, progress);
  if (!head.unit.empty())
  {
    vtkNew<vtkStringArray> unit;
    unit->SetName("Unit");
    unit->InsertNextValue(head.unit);
    map.surface->GetFieldData()->AddArray(unit);
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(map.surface);
  writer->SetDataModeToBinary(); // see Results
  folder.write(writer, "thickness.vtp");
  folder.writeText(page(simplify, map, this->pictures(map, folder), head), "report.html");
}
