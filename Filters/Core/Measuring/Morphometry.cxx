// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Morphometry.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace medial
{
namespace
{
using Of = const MorphometryIngredients&;

/// Not a number where there is nothing to divide by.
double ratio(double a, double b)
{
  return b > 0 ? a / b : Unknown;
}

/// How many there are along a line: of a number in a volume its cube root is taken.
double perLength(double number, double volume)
{
  return std::cbrt(ratio(number, volume));
}

/// Up to here the mean thickness of plates, rods and shells is right within 1 %, see README.md.
constexpr double CoarseSpacing = 0.28;

constexpr Quantity Table[] = {
  { "TV", 3, "Total volume: of the volume of interest.", "", [](Of i) { return i.totalVolume; } },
  { "BV", 3, "Bone volume: what of it the solid fills.", "", [](Of i) { return i.solidVolume; } },
  { "BV/TV", 0, "Bone volume fraction.", "BV / TV",
    [](Of i) { return ratio(i.solidVolume, i.totalVolume); } },
  { "BS", 2, "Bone surface: area of the solid's surface.", "", [](Of i) { return i.surfaceArea; } },
  { "BS/BV", -1, "Specific bone surface.", "BS / BV",
    [](Of i) { return ratio(i.surfaceArea, i.solidVolume); } },
  { "Tb.Th", 1, "Mean thickness over the solid's volume.", "",
    [](Of i) { return i.volume.thickness.mean; } },
  { "Tb.Th.SD", 1, "Standard deviation of the thickness.", "",
    [](Of i) { return i.volume.thickness.deviation; } },
  { "Tb.Th.Max", 1, "Largest thickness.", "", [](Of i) { return i.volume.thickness.largest; } },
  { "Tb.Sp", 1, "Mean separation over the volume between the solid's parts.", "",
    [](Of i) { return i.volume.separation.mean; } },
  { "Tb.Sp.SD", 1, "Standard deviation of the separation.", "",
    [](Of i) { return i.volume.separation.deviation; } },
  { "Tb.Sp.Max", 1, "Largest separation.", "", [](Of i) { return i.volume.separation.largest; } },
  { "Euler", 0, "Euler characteristic of the whole solid.", "pieces - tunnels + voids",
    [](Of i) { return i.euler; } },
  { "Euler.VOI", 0, "Share of the volume of interest in it, without edge effects.",
    "curvature of the surface there / 720 degrees", [](Of i) { return i.eulerWithin; } },
  { "Conn.D", -3,
    "Connectivity density of the whole solid; unknown where the volume of interest cuts it.",
    "(1 - Euler) / TV",
    [](Of i) { return i.isWhole ? ratio(1 - i.euler, i.totalVolume) : Unknown; } },
  { "Conn.D.VOI", -3, "Connectivity density in the volume of interest, without edge effects.",
    "(1 - Euler.VOI) / TV", [](Of i) { return ratio(1 - i.eulerWithin, i.totalVolume); } },
  { "DA", 0, "Degree of anisotropy: 0 the same in all directions, 1 none across one direction.",
    "1 - smallest / largest eigenvalue of the fabric of mean intercept lengths",
    [](Of i) { return i.anisotropy; } },
  { "pBV/BV", 0, "Share of the solid's volume that is in plates.",
    "none of it where width / thickness is up to 1.25, all from 1.75 on",
    [](Of i) { return i.plateShare; } },
  { "rBV/BV", 0, "Share of the solid's volume that is in rods.", "1 - pBV/BV",
    [](Of i) { return i.rodShare; } },
  { "pTb.N", -1, "Number of plates along a line.", "cube root of (plates / TV)",
    [](Of i) { return perLength(i.plates, i.totalVolume); } },
  { "rTb.N", -1, "Number of rods along a line.", "cube root of (rods / TV)",
    [](Of i) { return perLength(i.rods, i.totalVolume); } },
  { "pTb.Th", 1, "Mean thickness of plates.", "", [](Of i) { return i.plateThickness; } },
  { "rTb.Th", 1, "Mean thickness of rods.", "", [](Of i) { return i.rodThickness; } },
  { "Tb.PW", 1, "Mean width of plates.", "", [](Of i) { return i.plateWidth; } },
  { "pTb.S", 2, "Mean area of a plate, on one side.", "", [](Of i) { return i.plateArea; } },
  { "rTb.L", 1, "Mean length of a rod.", "", [](Of i) { return i.rodLength; } },
  { "P-P.Junc.D", -3, "Density of junctions of plates.", "junctions of the whole solid / TV",
    [](Of i) { return ratio(i.plateJunctions, i.totalVolume); } },
  { "P-R.Junc.D", -3, "Density of junctions of plates and rods.",
    "junctions of the whole solid / TV",
    [](Of i) { return ratio(i.mixedJunctions, i.totalVolume); } },
  { "R-R.Junc.D", -3, "Density of junctions of rods.", "junctions of the whole solid / TV",
    [](Of i) { return ratio(i.rodJunctions, i.totalVolume); } },
  { "Tb.NA", -1, "Network area density: area of the medial axis in the volume of interest.",
    "area of the axis / TV", [](Of i) { return ratio(i.axisArea, i.totalVolume); } },
  { "Ct.Th", 1,
    "Mean thickness of a shell: of a solid of one piece around one void, without tunnels.",
    "Tb.Th of such a solid", [](Of i) { return i.isShell ? i.volume.thickness.mean : Unknown; } },
  { "Spacing/Tb.Th", 0, "How coarse the samples are for the thickness.",
    "mean distance of a sample to the nearest other one / Tb.Th",
    [](Of i) { return ratio(i.spacing, i.volume.thickness.mean); } },
};
}

const std::vector<Quantity>& allQuantities()
{
  static const std::vector<Quantity> all(std::begin(Table), std::end(Table));
  return all;
}

std::string unitOf(const Quantity& quantity, const std::string& length)
{
  std::string unit = length.empty() ? "unit" : length;
  switch (quantity.power)
  {
    case 0:
      return "1";
    case 1:
      return unit;
    default:
      return unit + "^" + std::to_string(quantity.power);
  }
}

std::vector<double> morphometry(const MorphometryIngredients& ingredients)
{
  std::vector<double> result;
  for (const Quantity& quantity : allQuantities())
  {
    result.push_back(quantity.value(ingredients));
  }
  return result;
}

Warnings morphometryWarnings(const MorphometryIngredients& ingredients)
{
  const double coarseness = ratio(ingredients.spacing, ingredients.volume.thickness.mean);
  if (!(coarseness > CoarseSpacing))
  {
    return {};
  }
  Warning warning;
  warning.code = "coarse_for_thickness";
  warning.text =
    text("The samples are ", coarseness, " of the mean thickness apart, more than ", CoarseSpacing,
      ": thickness may be wrong by some per cent where the solid is thin. Sample it more densely.");
  return { warning };
}
}
