// SPDX-License-Identifier: BSD-3-Clause
#ifndef OutputFolder_h
#define OutputFolder_h

#include "DurableFiles.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class vtkMedialMeshWriter;
class vtkSTLWriter;
class vtkXMLWriter;

/// The folder of the results. Files are written to a draft, a hidden folder of a fresh name beside the
/// results' folder (inside it, where its parent can't be written to or is on another disk), and are
/// published together, see Publication.h. A run that fails, or is ended by a signal, leaves neither files
/// nor drafts. What a killed run left is removed by the next run with the same folder, but never the
/// draft of a run that is still at work: runs lock their drafts.
///
/// Concurrent runs with the same folder publish one after the other; the last one's results stay.
class OutputFolder
{
public:
  /// Makes the folders above it if they do not exist yet; the folder itself appears with its results.
  /// @param inputFile  is never overwritten
  /// @throw InputError  there can't be results in this folder, or they would overwrite the input
  OutputFolder(const std::string& folder, const std::string& inputFile);

  /// Removes what was not published.
  ~OutputFolder();

  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Writes a file by a writer whose input is set. VTK's XML writers corrupt the heap if the disk is full,
  /// so they write into memory.
  /// @throw InputError  the file can't be written
  void write(vtkXMLWriter* writer, const std::string& name);
  void write(vtkMedialMeshWriter* writer, const std::string& name);
  void write(vtkSTLWriter* writer, const std::string& name);

  /// Writes a text file.
  /// @throw InputError  the file can't be written
  void writeText(const std::string& text, const std::string& name);

  /// The place of the files that are not published yet, for a process that writes some of them.
  /// @throw InputError  it can't be made
  std::filesystem::path draft();

  /// A folder of the draft for files that are never published.
  /// @throw InputError  it can't be made
  std::filesystem::path scratch();

  /// What becomes of the results in the folder that no written file replaces.
  enum OldResults
  {
    Kept,
    Replaced ///< all go, see resultNames()
  };

  /// Publishes all written files together. Later files begin a new draft.
  /// @throw InputError  they can't be published; the old results stay
  void publish(OldResults old);

  /// Removes the files that are not published.
  void discard();

  /// Where the results are published.
  const std::filesystem::path& path() const { return this->Folder; }

private:
  void checkPlace(const std::string& inputFile) const;
  void makeParents();
  void removeStale() const;
  bool publishAsNew(const std::filesystem::path& draftFolder);
  bool makeDraft(const std::filesystem::path& place, const std::string& prefix);
  void removeDraft();
  void removeAll();

  std::string Named; ///< as the user wrote it, for messages
  std::filesystem::path Folder;
  std::vector<std::filesystem::path> MadeParents; ///< the outermost first
  std::filesystem::path Draft;                    ///< empty: there is none
  std::optional<FolderLock> DraftLock;
};

#endif
