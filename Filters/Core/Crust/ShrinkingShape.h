// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ShrinkingShape_h
#define medial_ShrinkingShape_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Does the power shape keep its topology if an outer ball replaces some cells of the triangulation? The
/// shape then loses its simplices inside of them. It keeps the topology if these are gone after a row of
/// elementary collapses, each of a simplex and the only larger one that it is in.
///
/// What is true is sure. False may be wrong, but is so for few: the collapses are made as they come.
/// O(n log n) for n cells, whatever the size of the triangulation.
/// @param replaced  the cells, see RegularTriangulation::replacedBy
/// @param inner     for each ball: is it in the shape?
bool shrinksByCollapses(const std::vector<Tetrahedron>& replaced, const std::vector<char>& inner);
}

#endif
