// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportPage_h
#define ReportPage_h

#include "DrawingProcess.h"

#include <optional>
#include <string>

class OutputFolder;
class Progress;
class vtkSimplifyShape;
class vtkTable;
struct PageHead;
struct PagePictures;
struct ThicknessMap;

/// Makes report.html and thickness.vtp. Without an X server the page has no pictures, and says why.
class ReportPage
{
public:
  /// Starts the process that draws. Call it before other threads use VTK, see DrawingProcess.h.
  ReportPage();

  /// Measures the thickness and writes both files, when the other results are written.
  /// @param means  over the volume, see thicknessMap()
  /// @throw InputError  the thickness can't be measured, or a file can't be written
  void write(vtkSimplifyShape* simplify, const PageHead& head, vtkTable* means, Progress& progress,
    OutputFolder& folder);

private:
  PagePictures pictures(const ThicknessMap& map, OutputFolder& folder);

  std::optional<DrawingProcess> Drawing;
  std::string Missing; ///< why nothing can be drawn
};

#endif
