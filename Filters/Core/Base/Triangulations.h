// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Triangulations_h
#define medial_Triangulations_h

#include "Base/Execution.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <memory>
#include <vector>

namespace medial
{
/// The Delaunay triangulation of distinct points; no cells where they lie in a plane.
Tetrahedra delaunay(const std::vector<Point>& points, const Execution& execution = {});

/// Ball `number` with a radius changed by up to 5e-10 of itself, in the same way in every run.
///
/// All polar balls through a sample meet there, so the sample is a degenerate vertex of their power
/// diagram: more than four cells meet. Computed balls miss it by rounding errors, and exact arithmetic
/// would spend most of the time on deciding these. The change is far above the rounding errors and far
/// below the sample spacing, so that doubles decide nearly always.
Ball jittered(const Ball& ball, Index number);

/// The regular triangulation of balls, weights their squared radii: the dual of their power diagram.
/// A ball that has no power cell (hidden) is in no cell.
class RegularTriangulation
{
public:
  RegularTriangulation();
  ~RegularTriangulation();
  RegularTriangulation(RegularTriangulation&&) noexcept;
  RegularTriangulation& operator=(RegularTriangulation&&) noexcept;

  RegularTriangulation copy() const;

  /// Adds balls; they are numbered on from those already there.
  void insert(const std::vector<Ball>& balls, const Execution& execution = {});

  /// The cells that would be gone if a ball was inserted, in no particular order; none where it would be hidden.
  /// The vertex at infinity is None.
  std::vector<Tetrahedron> replacedBy(const Ball& ball) const;

  /// For each cell that `tetrahedra` would give now, its number when it was called last; None for a cell that
  /// is new since then.
  std::vector<Index> numbersBefore() const;

  /// The triangulation of all balls inserted so far.
  Tetrahedra tetrahedra(const Execution& execution = {}) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};
}

#endif
