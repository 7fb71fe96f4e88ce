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
