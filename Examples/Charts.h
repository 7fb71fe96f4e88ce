// SPDX-License-Identifier: BSD-3-Clause
#ifndef Charts_h
#define Charts_h

#include <string>
#include <vector>

// Drawings for a page, as SVG within HTML.

/// What a chart shows.
struct ChartLabels
{
  std::string name;  ///< "Thickness"
  std::string unit;  ///< "mm"; empty: not known
  std::string space; ///< what its shares are of: "solid"
};

/// The colours of a scale from 0 to `top`, with numbers.
/// @param id  of the drawing; no two on a page have the same
std::string legend(const std::string& id, double top, const ChartLabels& labels);

/// A bar for each of equal ranges from 0 to `largest`, and a line at the mean.
/// @param top  of the scale that colours the bars as in legend(); 0: they are all grey
std::string histogram(const std::vector<double>& counts, double largest, double mean, double top,
  const ChartLabels& labels);

#endif
