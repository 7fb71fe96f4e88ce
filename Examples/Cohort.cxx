// SPDX-License-Identifier: BSD-3-Clause
#include "Cohort.h"

#include "ChildProcess.h"
#include "DurableFiles.h"
#include "Lines.h"
#include "Morphometry.h"
#include "Ranks.h"
#include "Tables.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <numeric>
#include <system_error>
#include <vector>

namespace fs = std::filesystem;

namespace
{
const std::string FailedMark = ".failed-"; ///< in the names of the files of rows with a reason

/// FNV-1a: the same for every run and compiler.
std::string hashOf(const std::string& text)
{
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text)
  {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  }
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

/// Of what is not there: 0.
std::string sizeAndTime(const fs::path& file)
{
  std::error_code missing;
  const auto size = fs::file_size(file, missing);
  const auto time = fs::last_write_time(file, missing).time_since_epoch().count();
  return std::to_string(fs::is_regular_file(file, missing) ? size : 0) + ' ' + std::to_string(time);
}

/// In bytes; of a folder, such as a DICOM series, that of the files in it. 0 of what is not there.
std::uintmax_t sizeOf(const fs::path& input)
{
  std::error_code missing;
  std::uintmax_t result = 0;
  if (fs::is_directory(input, missing))
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(input, missing))
    {
      result += entry.is_regular_file(missing) ? sizeOf(entry.path()) : 0;
    }
    return result;
  }
  const auto size = fs::file_size(input, missing);
  return missing ? 0 : size;
}

/// The objects of one of several processes, ascending. The largest are dealt out first, of equal ones the lower name,
/// each to the process that has least. All processes find the same shares.
std::vector<std::size_t> shareOf(const std::vector<std::string>& inputs, const Rank& rank)
{
  std::vector<std::uintmax_t> sizes;
  for (const std::string& input : inputs)
  {
    sizes.push_back(sizeOf(input) + 1); // so that files that are not there are shared, too
  }
  std::vector<std::size_t> order(inputs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sizes[a] != sizes[b] ? sizes[a] > sizes[b] : inputs[a] < inputs[b];
  });
  std::vector<std::uintmax_t> loads(static_cast<std::size_t>(rank.count), 0);
  std::vector<std::size_t> result;
  for (const std::size_t object : order)
  {
    const auto least = std::min_element(loads.begin(), loads.end());
    *least += sizes[object];
    if (least - loads.begin() == rank.number)
    {
      result.push_back(object);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// `--cohort bones/*.stl` lacks the table; the first bone must not become it.
void requireTable(const std::string& file)
{
  const bool isNew = !fs::exists(file);
  if (fs::path(file).extension() != ".csv" ||
    (!isNew && (fs::is_directory(file) || contentOf(file).compare(0, 10, "File,Name,") != 0)))
  {
    throw UsageError("--cohort takes the file of the table first, a new one or that of an earlier "
                     "run, as in --cohort table.csv; " +
      file + " is none");
  }
}

std::string cellsOf(const std::vector<std::string>& texts)
{
  std::string line;
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    line += (i == 0 ? "" : ",") + csvCell(texts[i]);
  }
  return line;
}

/// The rows of a cohort as files in a folder.
class Rows
{
public:
  /// Forgets the reasons of earlier runs: who has none of these objects must not take them for new ones.
  Rows(const Arguments& arguments, const std::string& run)
    : Folder(arguments.cohort + ".rows")
    , Failed(FailedMark + hashOf(run))
  {
    fs::create_directories(fs::absolute(this->Folder));
    for (const std::string& input : arguments.inputs)
    {
      const std::string path = fs::absolute(input).lexically_normal().string();
      this->Files.push_back(this->Folder /
        (objectName(input) + '-' +
          hashOf(path + '\n' + sizeAndTime(path) + '\n' + arguments.settings) + ".csv"));
    }
    this->forgetEarlierRuns();
  }

  bool isMeasured(std::size_t object) const { return fs::exists(this->Files[object]); }
  bool hasFailed(std::size_t object) const { return fs::exists(this->failed(object)); }
  void forgetFailure(std::size_t object) const { fs::remove(this->failed(object)); }

  void write(std::size_t object, const std::string& row, bool isFailure) const
  {
    const FolderLock lock(this->Folder, FolderLock::Wait);
    replaceFile(isFailure ? this->failed(object) : this->Files[object], row);
  }

  std::string read(std::size_t object) const
  {
    return contentOf(
      (this->isMeasured(object) ? this->Files[object] : this->failed(object)).string());
  }

  /// How many objects have neither a row nor a reason.
  std::size_t missing() const
  {
    std::size_t result = 0;
    for (std::size_t object = 0; object < this->Files.size(); ++object)
    {
      result += !this->isMeasured(object) && !this->hasFailed(object);
    }
    return result;
  }

  const fs::path Folder;

private:
  fs::path failed(std::size_t object) const { return this->Files[object].string() + this->Failed; }

  void forgetEarlierRuns() const
  {
    const FolderLock lock(this->Folder, FolderLock::Wait); // nobody is just writing one
    std::error_code gone;
    for (const fs::directory_entry& entry : fs::directory_iterator(this->Folder))
    {
      const std::string name = entry.path().filename().string();
      const std::size_t mark = name.rfind(FailedMark);
      if (mark != std::string::npos && name.compare(mark, this->Failed.size(), this->Failed) != 0)
      {
        fs::remove(entry.path(), gone);
      }
    }
  }

  std::string Failed; ///< ends the names of the files with a reason of this run

  std::vector<fs::path> Files;
};

struct Measured
{
  std::string row;    ///< a line
  std::string reason; ///< why there are no values
};

Measured failure(const std::string& file, const std::string& unit, const std::string& reason)
{
  std::vector<std::string> cells(morphometryColumns().size() + 2);
  cells[0] = file;
  cells[1] = objectName(file);
  cells[2] = unit;
  cells.back() = reason;
  return { cellsOf(cells) + '\n', reason };
}

/// Measures one object in a child process.
Measured measured(
  const Arguments& arguments, const std::function<std::string(const Arguments&)>& measure)
{
  const ChildResult result = inChildProcess([&] { return measure(arguments); });
  const std::string& file = arguments.input;
  if (result.ending == Ending::Threw)
  {
    const std::string prefix = file + ": ";
    const bool isNamed = result.text.compare(0, prefix.size(), prefix) == 0;
    return failure(file, arguments.unit, isNamed ? result.text.substr(prefix.size()) : result.text);
  }
  if (result.ending == Ending::Died)
  {
    return failure(file, arguments.unit, "the process that measured it " + result.text);
  }
  const std::size_t header = result.text.find('\n');
  const std::string row = result.text.substr(header + 1);
  return { csvCell(file) + ',' + row.substr(0, row.find_last_not_of('\n') + 1) + ",\n", "" };
}

void tell(const Arguments& arguments, std::size_t object, const Measured& measured, double seconds)
{
  if (!measured.reason.empty())
  {
    std::cerr << "SimplifyShape: " << arguments.inputs[object] << ": " << measured.reason << '\n';
  }
  else if (!arguments.quiet)
  {
    char text[64];
    std::snprintf(text, sizeof text, ": %.1f s", seconds);
    std::cout << object + 1 << '/' << arguments.inputs.size() << ' ' << arguments.inputs[object]
              << text << std::endl;
  }
}

void measureMine(const Arguments& arguments, const Rank& rank, const Rows& rows,
  const std::function<std::string(const Arguments&)>& measure)
{
  using Clock = std::chrono::steady_clock;
  const std::vector<std::size_t> mine = shareOf(arguments.inputs, rank);
  for (const std::size_t object : mine)
  {
    rows.forgetFailure(object);
  }
  for (const std::size_t object : mine)
  {
    if (rows.isMeasured(object))
    {
      continue;
    }
    const Clock::time_point begin = Clock::now();
    Arguments one = arguments;
    one.input = arguments.inputs[object];
    one.quiet = true;
    one.output = (fs::path(arguments.output) / objectName(one.input)).string();
    const Measured result = measured(one, measure);
    rows.write(object, result.row, !result.reason.empty());
    tell(arguments, object, result, std::chrono::duration<double>(Clock::now() - begin).count());
  }
}

ExitCode writeTable(const Arguments& arguments, const Rows& rows)
{
  std::vector<std::string> columns = morphometryColumns();
  columns.insert(columns.begin(), "File");
  columns.emplace_back("Error");
  std::string table = cellsOf(columns) + '\n';
  std::size_t failed = 0;
  for (std::size_t object = 0; object < arguments.inputs.size(); ++object)
  {
    table += rows.read(object);
    failed += !rows.isMeasured(object);
  }
  {
    const FolderLock lock(rows.Folder, FolderLock::Wait);
    replaceFile(arguments.cohort, table);
  }
  if (!arguments.quiet)
  {
    std::cout << arguments.cohort << ": " << arguments.inputs.size() - failed << " objects, "
              << failed << " failed" << std::endl;
  }
  return failed > 0 ? SomeFailed : Done;
}
}

ExitCode measureCohort(
  const Arguments& arguments, const std::function<std::string(const Arguments&)>& measure)
{
  requireTable(arguments.cohort);
  const Rank rank = rankOfLauncher();
  const Rows rows(arguments, rank.run);
  measureMine(arguments, rank, rows, measure);
  const std::size_t missing = rows.missing();
  if (missing == 0)
  {
    return writeTable(arguments, rows);
  }
  if (!arguments.quiet)
  {
    std::cout << "process " << rank.number << " of " << rank.count << " is done; " << missing
              << " objects are left to the others" << std::endl;
  }
  return Done;
}
