// SPDX-License-Identifier: BSD-3-Clause
#ifndef Progress_h
#define Progress_h

#include <string>

class vtkAlgorithm;

/// Runs filters, with a bar for each of them where somebody watches at a terminal.
class Progress
{
public:
  /// @param subject  what errors are about: the input
  Progress(const std::string& subject, bool quiet);

  /// Updates the filter and returns the seconds it took.
  /// @throw InputError  the filter reported an error; the message is the filter's
  double run(const std::string& stage, vtkAlgorithm* filter);

private:
  std::string Subject;
  bool Visible;
};

#endif
