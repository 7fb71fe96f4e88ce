// SPDX-License-Identifier: BSD-3-Clause
#ifndef Progress_h
#define Progress_h

#include <memory>
#include <string>
#include <vector>

class vtkAlgorithm;

/// Measures the time of each stage of a filter and, if standard error is a terminal, draws a bar for
/// it while it runs.
class Progress
{
public:
  explicit Progress(bool quiet);
  ~Progress();

  /// Watches a stage from now on.
  /// @param name  stands before the bar
  void watch(const std::string& name, vtkAlgorithm* stage);

  /// How long a watched stage took when it last ran; 0 if it has not run.
  double seconds(vtkAlgorithm* stage) const;

private:
  class Stage;

  bool Visible;
  std::vector<std::unique_ptr<Stage>> Stages;
};

/// The most memory that the process has had.
double peakMemoryMiB();

#endif
