// SPDX-License-Identifier: BSD-3-Clause
#include "ReadPoints.h"

#include "Errors.h"
#include "Messages.h"
#include "ReadText.h"

#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace
{
std::string lowerCaseExtension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

/// @throw InputError  there is no such file, or it may not be read
void checkReadable(const std::string& file)
{
  if (std::filesystem::is_directory(file))
  {
    throw InputError(file + ": is a folder, not a file of points");
  }
  if (!std::ifstream(file))
  {
    throw InputError(file + ": " + std::strerror(errno));
  }
}

/// The points that one of VTK's readers finds.
template <typename Reader>
vtkSmartPointer<vtkPoints> readWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPointSet* output = reader->GetOutput();
  if (!messages::error().empty())
  {
    throw InputError(
      file + ": can't be read as " + lowerCaseExtension(file) + ": " + messages::error());
  }
  if (!output || !output->GetPoints())
  {
    throw InputError(file + ": no points can be read from it");
  }
  messages::clear();
  return output->GetPoints();
}

vtkSmartPointer<vtkPoints> read(const std::string& file, const std::string& extension)
{
  using Read = vtkSmartPointer<vtkPoints> (*)(const std::string&);
  static const std::pair<const char*, Read> readers[] = {
    { ".ply", readWith<vtkPLYReader> },
    { ".stl", readWith<vtkSTLReader> },
    { ".obj", readWith<vtkOBJReader> },
    { ".vtp", readWith<vtkXMLPolyDataReader> },
    { ".vtu", readWith<vtkXMLUnstructuredGridReader> },
    { ".off", readOff },
    { ".xyz", readXyz },
  };
  for (const auto& [name, reader] : readers)
  {
    if (extension == name)
    {
      return reader(file);
    }
  }
  throw InputError(file + ": can't read '" + extension +
    "' files; convert it to .ply .stl .obj .vtp .vtu .off or .xyz");
}
}

vtkSmartPointer<vtkPolyData> readPoints(const std::string& file)
{
  checkReadable(file);
  auto samples = vtkSmartPointer<vtkPolyData>::New();
  samples->SetPoints(read(file, lowerCaseExtension(file)));
  return samples;
}
