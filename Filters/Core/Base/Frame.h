// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Frame_h
#define medial_Frame_h

#include "Base/Types.h"

#include <Eigen/Geometry>

#include <vector>

namespace medial
{
/// Where geometry is constructed: centred, and scaled by a power of two to a size of about 1, so that
/// results depend on neither unit nor position.
struct Frame
{
  Point center = Point::Zero();
  double scale = 1; ///< power of two

  Point toLocal(const Point& p) const { return (p - this->center) * this->scale; }
  Point toWorld(const Point& p) const { return p / this->scale + this->center; }
  Ball toLocal(const Ball& b) const { return { this->toLocal(b.center), b.radius * this->scale }; }
  Ball toWorld(const Ball& b) const { return { this->toWorld(b.center), b.radius / this->scale }; }
};

Eigen::AlignedBox3d boundingBox(const std::vector<Point>& points);

/// The frame of the points' bounding box, whose largest side becomes 0.5 ... 1.
/// @throw InvalidInput  no points; a coordinate that is not finite; all points in one place; a size
///                      whose cube leaves the range of doubles
Frame frameOf(const std::vector<Point>& points);

/// Lengths in a frame below which constructions are the same: 2e-9 of the diagonal, which is at most
/// 1.74, so that neither points nor midpoints of edges with a common end coincide at 1e-9. Doubles
/// leave 1e-13 for well-conditioned constructions; samples are some 1e-3 apart.
constexpr double coincident = 3.5e-9;

/// Error allowed to constructions in a frame, well below `coincident`.
constexpr double constructionError = 1e-12;
}

#endif
