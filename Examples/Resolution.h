// SPDX-License-Identifier: BSD-3-Clause
#ifndef Resolution_h
#define Resolution_h

#include <limits>
#include <string_view>

/// The unit to which the coordinates in a text were rounded: that of the last digit of the largest ones, if
/// these have as many digits as the one with the most. Zeros at the end may be missing, as in 0.5 beside 0.125,
/// and small numbers may have more decimals, as 0.00125 beside 12.5. Whole numbers without a point are exact.
class Resolution
{
public:
  /// @param word  a decimal number
  void add(std::string_view word);

  /// The unit, such as 0.001; 0 where no coordinate had a point or an exponent.
  double value() const;

private:
  int highest = std::numeric_limits<int>::min(); ///< power of ten of the largest one's first digit
  int digits = 0; ///< of the one with the most, from its first nonzero digit on
};

#endif
