// SPDX-License-Identifier: BSD-3-Clause
#ifndef MedialMeshParser_h
#define MedialMeshParser_h

#include "Base/Execution.h"
#include "Exchange/MedialMesh.h"

#include <string>
#include <string_view>

namespace medial
{
/// What parsedMedialMesh() makes of a text.
struct ParsedMedialMesh
{
  MedialMesh mesh;
  Index repeated = 0;   ///< edges and triangles that came again, and were left out
  Index tetrahedra = 0; ///< that were left out
};

/// The medial mesh in the text of a .ma file. The first line has the numbers of points, edges and triangles;
/// then come, in any order, lines of words with blanks between,
///
///     v x y z r      a point and the radius of its ball
///     e i j          an edge, by its points, counted from 0
///     f i j k        a triangle
///
/// Blank lines, and what follows a #, are skipped. Beside this form, which Q-MAT began with, these are read:
///  - A type, a whole number, at the end of v and e lines (MATTopo).
///  - Files of four numbers in the first line (.ma_dup of MATTopo): v and e lines with type, deleted (0 or 1)
///    and a number of copies, f lines with importance, deleted and copies, and lines `t i j k l`, tetrahedra,
///    with deleted and copies. What is deleted is left out, and so are the tetrahedra: they are checked and counted.
///    Importance and copies are not kept.
///  - Points counted from 1 (Coverage Axis, earlier versions): where the number of points occurs as an
///    index and 0 never does. If the last point is in no cell, nothing tells these files from the others.
///
/// Edges that are sides of a triangle are listed in most files; they are not made edges again, unless they have a type
/// other than 0. Points in no cell become vertices. What comes again is taken once.
///
/// Not read: two numbers after the points of an e line. MATFP means type and deleted by them, Blender's
/// importer deleted and type.
///
/// @param name  of the file, for errors
/// @throw InvalidInput  with the number of the line
ParsedMedialMesh parsedMedialMesh(
  const std::string& name, std::string_view text, const Execution& execution);
}

#endif
