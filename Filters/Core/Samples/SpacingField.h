// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SpacingField_h
#define medial_SpacingField_h

#include "Base/Execution.h"
#include "Base/Neighbors.h"
#include "Base/Types.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace medial
{
/// How far samples may be apart, everywhere. It is given at some points and grows away from them by
/// `grading` times the distance, up to the largest spacing.
class SpacingField
{
public:
  /// The same everywhere.
  explicit SpacingField(double largest)
    : largest(largest)
  {
  }

  /// @param points    where it is given
  /// @param spacings  at most so much at each
  SpacingField(double largest, std::vector<Point> points, std::vector<double> spacings,
    const Execution& execution = {});

  double at(const Point& point) const;

  /// It is nowhere more.
  double most() const { return std::max(this->largest, this->least); }

  /// The same, but nowhere less.
  SpacingField atLeast(double least) const;

  /// A place where it is least, if it is not the same everywhere.
  std::optional<Point> tightest() const;

  static constexpr double grading = 0.3; ///< samples are in balance with their neighbours' spacing

private:
  double largest;
  double least = 0;
  std::shared_ptr<const std::vector<Point>> points;
  std::vector<double> spacings;
  std::shared_ptr<const Neighbors> neighbors;
};
}

#endif
