// SPDX-License-Identifier: BSD-3-Clause
#ifndef ResultNames_h
#define ResultNames_h

#include <set>
#include <string>

/// The names of all files that the program may write. New results take the place of all files of these
/// names: a picture of an older result does not stay beside them.
inline const std::set<std::string> ResultNames = { "balls.vtu", "samples.vtp", "axis.vtp",
  "parts.vtp", "pruned.vtp", "surface.vtp", "surface.stl", "parts.csv", "history.csv",
  "report.json", "samples.png", "axis.png", "parts.png", "pruned.png", "surface.png",
  "overview.png" };

#endif
