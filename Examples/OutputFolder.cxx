// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFolder.h"

#include "Errors.h"
#include "Messages.h"
#include "Publication.h"
#include "ResultNames.h"
#include "Signals.h"

#include <vtkErrorCode.h>
#include <vtkMedialMeshWriter.h>
#include <vtkSTLWriter.h>
#include <vtkXMLWriter.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
const std::string DraftMark = ".SimplifyShape-"; ///< followed by six characters of mkdtemp()

/// A draft holds these three at most, see Publication.h. A folder with anything else is not ours.
bool looksLikeDraft(const fs::path& folder)
{
  std::error_code unreadable;
  const fs::directory_iterator entries(folder, unreadable);
  return !unreadable && std::all_of(begin(entries), end(entries), [](const auto& entry) {
    const fs::path name = entry.path().filename();
    return name == "new" || name == "old" || name == "now";
  });
}

/// Removes the drafts at a place whose runs have ended.
void removeStaleDrafts(const fs::path& place, const std::string& prefix)
{
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(place, ignored))
  {
    const std::string name = entry.path().filename().string();
    if (name.size() == prefix.size() + 6 && name.compare(0, prefix.size(), prefix) == 0 &&
      entry.is_directory(ignored) && !entry.is_symlink(ignored) && looksLikeDraft(entry.path()))
    {
      const FolderLock lock(entry.path(), FolderLock::Try);
      if (lock.isHeld())
      {
        fs::remove_all(entry.path(), ignored);
      }
    }
  }
}

bool sameDisk(const fs::path& a, const fs::path& b)
{
  struct stat first = {}, second = {};
  return stat(a.c_str(), &first) == 0 && stat(b.c_str(), &second) == 0 &&
    first.st_dev == second.st_dev;
}

void checkWritable(const fs::path& folder, const std::string& named)
{
  if (access(folder.c_str(), W_OK | X_OK) != 0)
  {
    throw InputError(named + ": this folder for the results can't be written to: " +
      std::generic_category().message(errno));
  }
}

[[noreturn]] void failToWrite(const fs::path& file, const std::string& reason)
{
  throw InputError(file.string() + ": can't be written: " + reason);
}

/// Checks what a writer says of itself.
void check(const fs::path& file, vtkAlgorithm* writer)
{
  const unsigned long code = writer->GetErrorCode();
  if (code == vtkErrorCode::OutOfDiskSpaceError)
  {
    failToWrite(file, std::make_error_code(std::errc::no_space_on_device).message());
  }
  if (code != vtkErrorCode::NoError || !messages::error().empty())
  {
    failToWrite(file,
      messages::error().empty() ? vtkErrorCode::GetStringFromErrorCode(code) : messages::error());
  }
  messages::clear();
}
}

OutputFolder::OutputFolder(const std::string& folder, const std::string& inputFile)
  : Named(folder)
{
  try
  {
    this->Folder = fs::weakly_canonical(fs::absolute(folder));
    this->Folder =
      this->Folder.has_filename() ? this->Folder : this->Folder.parent_path(); // "out/"
    this->checkPlace(inputFile);
    this->removeStale();
    const signals::Shield shield;
    signals::setCleanUp([this] { this->removeAll(); });
    this->makeParents();
  }
  catch (const std::exception& error)
  {
    const signals::Shield shield;
    this->removeAll();
    signals::setCleanUp(nullptr);
    const auto* reason = dynamic_cast<const std::system_error*>(&error);
    throw InputError(!reason
        ? error.what()
        : folder + ": can't make this folder for the results: " + reason->code().message());
  }
}

OutputFolder::~OutputFolder()
{
  const signals::Shield shield;
  signals::setCleanUp(nullptr);
  this->removeAll();
}

void OutputFolder::checkPlace(const std::string& inputFile) const
{
  if (fs::is_directory(this->Folder))
  {
    checkWritable(this->Folder, this->Named);
  }
  else if (fs::exists(fs::symlink_status(this->Folder)))
  {
    throw InputError(
      this->Named + ": can't make this folder for the results: a file of that name is in the way");
  }
  for (const std::string& name : resultNames(this->Folder))
  {
    std::error_code notThere;
    if (fs::equivalent(this->Folder / name, inputFile, notThere))
    {
      throw InputError((fs::path(this->Named) / name).string() +
        ": is the input, which the results would overwrite; take another --output");
    }
  }
}

/// Another run may have been killed when it published.
void OutputFolder::removeStale() const
{
  removeStaleDrafts(this->Folder.parent_path(), "." + this->Folder.filename().string() + DraftMark);
  removeStaleDrafts(this->Folder, DraftMark);
  const FolderLock lock(this->Folder, FolderLock::Try);
  if (lock.isHeld())
  {
    finishSwitch(this->Folder);
  }
}

void OutputFolder::makeParents()
{
  std::vector<fs::path> missing;
  for (fs::path parent = this->Folder.parent_path(); !fs::exists(parent);
       parent = parent.parent_path())
  {
    missing.push_back(parent);
  }
  for (; !missing.empty(); missing.pop_back())
  {
    fs::create_directory(missing.back());
    this->MadeParents.push_back(missing.back());
  }
  if (!fs::exists(this->Folder))
  {
    checkWritable(this->Folder.parent_path(), this->Named);
  }
}

void OutputFolder::write(vtkXMLWriter* writer, const std::string& name)
{
  writer->WriteToOutputStringOn();
  writer->Write();
  check(fs::path(this->Named) / name, writer);
  this->writeText(writer->GetOutputString(), name);
}

void OutputFolder::write(vtkMedialMeshWriter* writer, const std::string& name)
{
  writer->WriteToOutputStringOn();
  writer->Write();
  check(fs::path(this->Named) / name, writer);
  this->writeText(writer->GetOutputString(), name);
}

void OutputFolder::write(vtkSTLWriter* writer, const std::string& name)
{
  const fs::path file = this->draft() / name;
  writer->SetFileName(file.c_str());
  writer->Write();
  check(fs::path(this->Named) / name, writer);
  try
  {
    sync(file);
  }
  catch (const std::system_error& error)
  {
    failToWrite(fs::path(this->Named) / name, error.code().message());
  }
}

void OutputFolder::writeText(const std::string& text, const std::string& name)
{
  const fs::path file = this->draft() / name;
  try
  {
    writeFile(file, text);
  }
  catch (const std::system_error& error)
  {
    failToWrite(fs::path(this->Named) / name, error.code().message());
  }
}

fs::path OutputFolder::draft()
{
  const signals::Shield shield;
  if (this->Draft.empty())
  {
    const fs::path parent = this->Folder.parent_path();
    const bool isNew = !fs::exists(this->Folder);
    const std::string prefix = "." + this->Folder.filename().string() + DraftMark;
    if (!((isNew || sameDisk(parent, this->Folder)) && this->makeDraft(parent, prefix)) &&
      (isNew || !this->makeDraft(this->Folder, DraftMark)))
    {
      throw InputError(
        this->Named + ": can't be written to: " + std::generic_category().message(errno));
    }
  }
  return this->Draft / "new";
}

fs::path OutputFolder::scratch()
{
  const fs::path result = this->draft().parent_path() / "scratch";
  const signals::Shield shield; // not twice: draft() has one of its own
  std::error_code error;
  fs::create_directory(result, error);
  if (error)
  {
    throw InputError(this->Named + ": can't be written to: " + error.message());
  }
  return result;
}

/// Tries again if another run takes the new folder for a stale draft before it is locked.
bool OutputFolder::makeDraft(const fs::path& place, const std::string& prefix)
{
  for (int attempt = 0; attempt < 3; ++attempt)
  {
    std::string name = (place / (prefix + "XXXXXX")).string();
    if (!mkdtemp(name.data()))
    {
      return false;
    }
    FolderLock lock(name, FolderLock::Wait);
    std::error_code error;
    fs::create_directory(fs::path(name) / "new", error);
    if (!error)
    {
      this->Draft = name;
      this->DraftLock = std::move(lock);
      return true;
    }
    fs::remove(name, error);
  }
  return false;
}

void OutputFolder::publish(OldResults old)
{
  const fs::path draftFolder = this->draft().parent_path();
  try
  {
    if (!this->publishAsNew(draftFolder))
    {
      const FolderLock lock(this->Folder, FolderLock::Wait);
      const std::set<std::string> names =
        old == Replaced ? resultNames(this->Folder) : std::set<std::string>();
      const signals::Shield shield;
      publishInto(draftFolder, this->Folder, names);
      this->Draft.clear();
    }
  }
  catch (const std::system_error& error)
  {
    throw InputError(this->Named + ": can't be written: " + error.code().message());
  }
  this->DraftLock.reset();
}

bool OutputFolder::publishAsNew(const fs::path& draftFolder)
{
  const signals::Shield shield;
  const bool isDone = publishAsFolder(draftFolder, this->Folder);
  if (isDone)
  {
    this->Draft.clear();
    this->MadeParents.clear();
  }
  return isDone;
}

void OutputFolder::discard()
{
  const signals::Shield shield;
  this->removeDraft();
}

/// Where a signal ends the program, the main thread or the process that draws may just make a file; then
/// the folder isn't empty, and the next attempt removes that, too.
void OutputFolder::removeDraft()
{
  std::error_code error;
  for (int attempt = 0; !this->Draft.empty() && attempt < 100; ++attempt)
  {
    fs::remove_all(this->Draft, error);
    if (!error)
    {
      this->Draft.clear();
    }
  }
  this->DraftLock.reset();
}

/// Of the folders above only those that are empty go.
void OutputFolder::removeAll()
{
  this->removeDraft();
  std::error_code notEmpty;
  for (; !this->MadeParents.empty(); this->MadeParents.pop_back())
  {
    fs::remove(this->MadeParents.back(), notEmpty);
  }
}
