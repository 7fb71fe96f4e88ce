// SPDX-License-Identifier: BSD-3-Clause
#include "Images/ImageWarnings.h"

#include "Base/BettiWords.h"
#include "Base/Errors.h"

#include <string>

namespace medial
{
namespace
{
Warning cutAtBorder(const std::array<Index, 6>& cut, const std::optional<Point>& place)
{
  static const std::array<const char*, 6> names = { "first i", "last i", "first j", "last j",
    "first k", "last k" };
  Index voxels = 0;
  std::string sides;
  for (int side = 0; side < 6; ++side)
  {
    voxels += cut[side];
    sides += cut[side] == 0 ? "" : (sides.empty() ? "" : ", ") + std::string(names[side]);
  }
  return { "cut_at_border",
    text("The solid reaches the border of the image (", sides, ") with ", voxels,
      " voxels. It is closed by flat faces there, as if it ended. Take an image that holds all of "
      "it if it doesn't."),
    voxels, place, false };
}

Warning otherThanVoxels(
  const Betti& segmentation, const Betti& surface, const std::optional<Point>& place)
{
  return { "smoothed_topology",
    text("The voxels of the solid have ", inWords(segmentation), "; their smoothed surface has ",
      inWords(surface),
      ". Details of one or two voxels differ. All that follows is compared with the surface: "
      "smooth "
      "less, or take a finer image, if they matter."),
    bettiDistance(segmentation, surface), place, false };
}
}

Warnings imageWarnings(const Betti& segmentation, const Betti& surface,
  const std::array<Index, 6>& cut, const std::optional<Point>& cutAt,
  const std::optional<Point>& differsAt)
{
  Warnings result;
  if (cut != std::array<Index, 6>{})
  {
    result.push_back(cutAtBorder(cut, cutAt));
  }
  if (segmentation != surface)
  {
    result.push_back(otherThanVoxels(segmentation, surface, differsAt));
  }
  return result;
}
}
