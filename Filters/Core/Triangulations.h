// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Triangulations_h
#define medial_Triangulations_h

#include "Execution.h"
#include "Tetrahedra.h"
#include "Types.h"

#include <memory>
#include <vector>

namespace medial
{
/// The Delaunay triangulation of distinct points; no cells where they lie in a plane.
Tetrahedra delaunay(const std::vector<Point>& points, const Execution& execution = {});

/// The regular triangulation of balls, weights their squared radii: the dual of their power diagram.
/// A ball that has no power cell (hidden) is in no cell.
///
/// Weights get a relative jitter of 1e-9, the same in every run: every sample is a degenerate vertex
/// of the power diagram, and without it exact arithmetic is spent on deciding rounding noise. Nothing
/// but the choice among equals depends on it.
class RegularTriangulation
{
public:
  RegularTriangulation();
  ~RegularTriangulation();
  RegularTriangulation(RegularTriangulation&&) noexcept;
  RegularTriangulation& operator=(RegularTriangulation&&) noexcept;

  /// Adds balls; they are numbered on from those already there.
  void insert(const std::vector<Ball>& balls, const Execution& execution = {});

  /// The triangulation of all balls inserted so far.
  Tetrahedra tetrahedra() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
}

#endif
