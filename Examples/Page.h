// SPDX-License-Identifier: BSD-3-Clause
#ifndef Page_h
#define Page_h

#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <string>

struct PagePictures;
struct ThicknessMap;
class vtkSimplifyShape;

/// What the outputs of the filter don't tell.
struct PageHead
{
  std::string name;                      ///< of the input
  std::string unit;                      ///< of its coordinates; empty: not known
  vtkSmartPointer<vtkTable> morphometry; ///< the row of vtkMorphometry; null: not asked for
};

/// The text of report.html: one page that needs no other file, no network and no script.
/// @param simplify  after an update
std::string page(vtkSimplifyShape* simplify, const ThicknessMap& map, const PagePictures& pictures,
  const PageHead& head);

#endif
