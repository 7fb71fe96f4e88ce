// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ContactCurves_h
#define medial_ContactCurves_h

#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"

#include <vector>

namespace medial
{
/// An unbroken polyline shared by touching parts (paper 4.3); or a point where a part touches others
/// but has no share in a polyline.
struct ContactCurve
{
  std::vector<Index> points; ///< medial points in order; first == last where it is closed
  std::vector<Index> parts;  ///< the parts that touch along it, ascending
};

/// The contacts of the living parts: polylines by lowest edge, then points, ascending.
///
/// Contact edges, where three triangles or more meet, are chained as long as the same parts meet there
/// and the point between two of them has no third. Cost: n log n in the number of contact edges, and
/// linear in the cells.
std::vector<ContactCurve> contacts(const LivingCells& living, const Partition& partition);
}

#endif
