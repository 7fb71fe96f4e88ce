// SPDX-License-Identifier: BSD-3-Clause
#include "ResultNames.h"

#include <charconv>
#include <system_error>

namespace fs = std::filesystem;

std::string partFileName(vtkIdType part)
{
  return "part-" + std::to_string(part) + ".stl";
}

namespace
{
bool isPartFileName(const std::string& name)
{
  const std::string beforeNumber = "part-";
  if (name.compare(0, beforeNumber.size(), beforeNumber) != 0)
  {
    return false;
  }
  vtkIdType part = -1;
  std::from_chars(name.data() + beforeNumber.size(), name.data() + name.size(), part);
  return part >= 0 && name == partFileName(part);
}
}

std::set<std::string> resultNames(const fs::path& folder)
{
  std::set<std::string> result = { "balls.vtu", "samples.vtp", "axis.vtp", "parts.vtp",
    "pruned.vtp", "surface.vtp", "surface.stl", "parts.csv", "history.csv", "morphometry.csv",
    "report.json", "axis.ma", "pruned.ma", "exported.csv", "thickness.vtp", "report.html",
    "samples.png", "axis.png", "parts.png", "pruned.png", "surface.png", "overview.png" };
  std::error_code notThere;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, notThere))
  {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    if (isPartFileName(name) && !fs::is_directory(entry.symlink_status(ignored)))
    {
      result.insert(name);
    }
  }
  return result;
}
