// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Distribution_h
#define medial_Distribution_h

#include "Base/Types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace medial
{
/// What a set of values is like. Not a number where there is no value.
struct Distribution
{
  double mean = std::numeric_limits<double>::quiet_NaN();
  double deviation = mean; ///< from the mean: root of the mean square
  double smallest = mean;
  double largest = mean;
  Index number = 0; ///< of values

  /// How many values are in each of equal ranges from 0 to the largest; one at a bound counts in the range above, the
  /// largest one in the last. Negative values count in the first.
  std::array<Index, 40> histogram{};
};

/// Adds values up in their order, so that the result doesn't depend on threads.
inline Distribution distribution(const std::vector<double>& values)
{
  Distribution result;
  if (values.empty())
  {
    return result;
  }
  double sum = 0, squares = 0;
  for (const double value : values)
  {
    sum += value;
  }
  result.mean = sum / double(values.size());
  for (const double value : values)
  {
    squares += (value - result.mean) * (value - result.mean);
  }
  result.deviation = std::sqrt(squares / double(values.size()));
  const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
  result.smallest = *smallest;
  result.largest = *largest;
  result.number = count(values);
  const int bins = static_cast<int>(result.histogram.size());
  for (const double value : values)
  {
    const double share = result.largest > 0 ? std::max(value / result.largest, 0.0) : 0;
    ++result.histogram[std::min(static_cast<int>(share * bins), bins - 1)];
  }
  return result;
}

/// The values that are numbers.
inline std::vector<double> known(const std::vector<double>& values)
{
  std::vector<double> result;
  std::copy_if(values.begin(), values.end(), std::back_inserter(result),
    [](double value) { return !std::isnan(value); });
  return result;
}
}

#endif
