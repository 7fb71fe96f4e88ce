// SPDX-License-Identifier: BSD-3-Clause
#ifndef OutputFolder_h
#define OutputFolder_h

#include <filesystem>
#include <string>

class vtkAlgorithm;

/// The folder of the results. Files are written to a draft folder within it and moved to their places at
/// the end, so that a run that fails leaves no results.
class OutputFolder
{
public:
  /// Makes the folder if it does not exist yet.
  /// @param inputFile  is never overwritten
  /// @throw InputError  the folder can't be made
  OutputFolder(const std::string& folder, const std::string& inputFile);

  /// Removes the files that were not published, and the folder if it is new and empty.
  ~OutputFolder();

  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file of this name by a vtkWriter or vtkImageWriter whose input is set.
  /// @throw InputError  the file can't be written
  template <typename Writer>
  void write(Writer* writer, const std::string& name)
  {
    writer->SetFileName(this->draft(name).c_str());
    writer->Write();
    this->check(name, writer);
  }

  /// Writes a text file.
  /// @throw InputError  the file can't be written
  void writeText(const std::string& text, const std::string& name);

  /// Moves all written files to their places.
  /// @throw InputError  a file can't be moved, or would overwrite the input; in the latter case none is
  ///                    moved
  void publish();

private:
  std::string draft(const std::string& name) const;
  void check(const std::string& name, vtkAlgorithm* writer) const;

  std::filesystem::path Folder;
  std::filesystem::path InputFile;
  std::filesystem::path Draft; ///< inside Folder, thus on the same disk
  bool IsNew;
};

#endif
