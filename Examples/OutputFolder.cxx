// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFolder.h"

#include "Errors.h"
#include "Messages.h"

#include <vtkAlgorithm.h>
#include <vtkErrorCode.h>

#include <fstream>
#include <unistd.h>

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const std::string& folder, const std::string& inputFile)
  : Folder(folder)
  , InputFile(inputFile)
  , Draft(this->Folder / (".draft-" + std::to_string(getpid())))
{
  std::error_code error;
  this->IsNew = fs::create_directories(this->Folder, error);
  if (error || !fs::is_directory(this->Folder))
  {
    throw InputError(folder + ": can't make this folder for the results: " +
      (error ? error.message() : "a file of that name is in the way"));
  }
  if (access(folder.c_str(), W_OK) != 0)
  {
    throw InputError(folder + ": this folder for the results can't be written to");
  }
}

OutputFolder::~OutputFolder()
{
  std::error_code ignored;
  fs::remove_all(this->Draft, ignored);
  if (this->IsNew)
  {
    fs::remove(this->Folder, ignored); // fails, as it should, if it has results in it
  }
}

void OutputFolder::writeText(const std::string& text, const std::string& name)
{
  std::ofstream stream(this->draft(name), std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
  {
    throw InputError((this->Folder / name).string() + ": can't be written");
  }
}

void OutputFolder::publish()
{
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Draft))
  {
    const fs::path target = this->Folder / entry.path().filename();
    std::error_code notThere;
    if (fs::equivalent(target, this->InputFile, notThere))
    {
      throw InputError(target.string() +
        ": is the input, which the results would overwrite; take another --output");
    }
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(this->Draft))
  {
    const fs::path target = this->Folder / entry.path().filename();
    std::error_code error;
    fs::rename(entry.path(), target, error);
    if (error)
    {
      throw InputError(target.string() + ": can't be written: " + error.message());
    }
  }
}

std::string OutputFolder::draft(const std::string& name) const
{
  std::error_code error;
  fs::create_directories(this->Draft, error);
  if (error)
  {
    throw InputError(this->Folder.string() + ": can't be written to: " + error.message());
  }
  return (this->Draft / name).string();
}

void OutputFolder::check(const std::string& name, vtkAlgorithm* writer) const
{
  const unsigned long code = writer->GetErrorCode();
  if (code != vtkErrorCode::NoError || !messages::error().empty() ||
    !fs::exists(this->Draft / name))
  {
    const std::string reason =
      messages::error().empty() ? vtkErrorCode::GetStringFromErrorCode(code) : messages::error();
    throw InputError((this->Folder / name).string() + ": can't be written: " + reason);
  }
  messages::clear();
}
