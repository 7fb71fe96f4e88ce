// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Anisotropy_h
#define medial_Anisotropy_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// How much a surface prefers a direction, by its mean intercept lengths: 0 where it looks the same from all
/// directions, 1 where straight lines in some direction never meet it.
///
/// A line in direction d meets the surface I(d) = sum |area . d| times, in the mean and up to a factor. The mean
/// intercept length is 1 / I(d). Its squares' inverse is fitted by a quadratic form, d^T M d (Harrigan and Mann
/// 1984), the fabric ellipsoid: its half axes are the inverse roots of the eigenvalues of M. The value is
/// 1 - smallest / largest eigenvalue of M, BoneJ's convention. The longest over the shortest half axis, the
/// standard's convention (Bouxsein 2010), is 1 / sqrt(1 - value). Exact up to rounding for every ellipsoid:
/// 1 - (shortest / longest axis)^2.
///
/// The directions are the same 1024 for all surfaces, in the surface's own frame of reference, so that a surface
/// that was turned has the same value. Cost: triangles times directions.
/// @param areas  the normal of each triangle, as long as its area
/// @return not a number where there is no area
double degreeOfAnisotropy(const std::vector<Point>& areas, const Execution& execution = {});
}

#endif
