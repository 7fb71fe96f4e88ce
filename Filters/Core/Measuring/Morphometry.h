// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Morphometry_h
#define medial_Morphometry_h

#include "Base/Warnings.h"
#include "Measuring/VolumeThickness.h"

#include <limits>
#include <string>
#include <vector>

/// The standard quantities of bone morphometry, of any solid: names, units and formulas as in Bouxsein et al.
/// 2010 where they are there.
///
/// To add a quantity: what it is made of, in `MorphometryIngredients`, and a row in the table of Morphometry.cxx.
/// Columns of tables, --help and the documents follow from the table.
namespace medial
{
/// For what isn't known. A quantity that needs it isn't a number either, never 0.
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

/// What the quantities are made of, in the samples' unit. Volumes and areas are those in the volume of interest.
struct MorphometryIngredients
{
  double totalVolume = Unknown; ///< of the volume of interest
  double solidVolume = Unknown;
  double surfaceArea = Unknown; ///< of the solid
  double axisArea = Unknown;    ///< of the medial axis
  double euler = Unknown;       ///< pieces - tunnels + voids of the whole solid
  double eulerWithin = Unknown; ///< the share of the volume of interest, see eulerWithin()
  bool isWhole = false;         ///< the volume of interest cuts nothing off the solid
  double anisotropy = Unknown;  ///< see degreeOfAnisotropy()
  double spacing = Unknown;     ///< of the samples

  /// Over the volume of the solid, and over what is between its parts.
  VolumeThickness volume;
  bool isShell = false; ///< one piece around one void, without tunnels

  double plateShare = Unknown; ///< of the solid's volume, 0 ... 1
  double rodShare = Unknown;
  double plates = Unknown; ///< how many
  double rods = Unknown;
  double plateThickness = Unknown; ///< mean
  double rodThickness = Unknown;
  double plateWidth = Unknown;
  double plateArea = Unknown; ///< mean of a plate
  double rodLength = Unknown; ///< mean of a rod
  // How many places where plates meet plates, plates rods, rods rods.
  double plateJunctions = Unknown;
  double mixedJunctions = Unknown;
  double rodJunctions = Unknown;
};

/// A row of the table of quantities: all there is to know about one.
struct Quantity
{
  const char* name; ///< as in the literature; also its column
  int power;        ///< of the unit of length: 3 for a volume, -1 for 1 / length, 0 for a number
  const char* description; ///< in one sentence
  const char* formula;     ///< from other quantities; empty where it is measured
  double (*value)(const MorphometryIngredients&);
};

/// All quantities, in the order of the columns.
const std::vector<Quantity>& allQuantities();

/// The unit of a quantity, such as "mm^3" or "mm^-1"; "1" for a number.
/// @param length  the unit of length; empty: not known, "unit" stands for it
std::string unitOf(const Quantity& quantity, const std::string& length);

/// One value for each quantity.
std::vector<double> morphometry(const MorphometryIngredients& ingredients);

/// "coarse_for_thickness": the samples are so far apart, compared with the mean thickness, that thin places have
/// few of them across.
Warnings morphometryWarnings(const MorphometryIngredients& ingredients);
}

#endif
