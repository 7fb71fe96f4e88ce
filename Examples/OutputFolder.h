// SPDX-License-Identifier: BSD-3-Clause
#ifndef OutputFolder_h
#define OutputFolder_h

#include <filesystem>
#include <string>

class vtkAlgorithm;

/// The folder of the results: all files appear together at the end, or none does.
class OutputFolder
{
public:
  /// Makes the folder where it isn't there yet.
  /// @throw InputError  it can't be made
  explicit OutputFolder(const std::string& folder);

  /// Removes what was not published, and the folder if it is new and empty.
  ~OutputFolder();

  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Runs a vtkWriter or vtkImageWriter whose input is set, for a file of this name.
  /// @throw InputError  the file can't be written
  template <typename Writer>
  void write(Writer* writer, const std::string& name)
  {
    writer->SetFileName(this->draft(name).c_str());
    writer->Write();
    this->check(name, writer);
  }

  /// @throw InputError  the file can't be written
  void writeText(const std::string& text, const std::string& name);

  /// Moves all files written to their place.
  /// @throw InputError  one can't be moved
  void publish();

private:
  std::string draft(const std::string& name) const;
  void check(const std::string& name, vtkAlgorithm* writer) const;

  std::filesystem::path Folder;
  std::filesystem::path Draft; ///< inside Folder, thus on the same disk
  bool IsNew;
};

#endif
