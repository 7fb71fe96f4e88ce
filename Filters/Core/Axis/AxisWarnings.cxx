// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisWarnings.h"

namespace medial
{
Warnings axisWarnings(const MedialAxis& axis)
{
  if (!axis.fallback)
  {
    return {};
  }
  return { { "fallback",
    "The medial axis, or connected pieces of it, is the collapsed power shape (fallback): its "
    "topology is right, its triangles are coarser there. More samples, or samples with less noise, "
    "may avoid it.",
    axis.cells.size(), {}, false } };
}
}
