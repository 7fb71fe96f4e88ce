// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Morphometry.h"

#include "Base/Errors.h"
#include "Measuring/Ingredients.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <vector>

using Box = Eigen::AlignedBox3d;
using medial::allQuantities;
using medial::MorphometryIngredients;
using medial::Point;
using medial::Quantity;

namespace
{
double valueOf(const char* name, const MorphometryIngredients& ingredients)
{
  for (const Quantity& quantity : allQuantities())
  {
    if (std::strcmp(quantity.name, name) == 0)
    {
      return quantity.value(ingredients);
    }
  }
  ADD_FAILURE() << "no quantity " << name;
  return 0;
}

/// A plate 4 x 4 x 0.5 with a square hole, whose axis is taken to be its middle.
struct Plate
{
  meshes::Mesh mesh = meshes::triangulated(meshes::drilledPlate(0.5));
  std::vector<medial::Triangle> triangles = meshes::triangles(this->mesh);
  medial::MedialAxis axis;

  Plate()
  {
    this->axis.points = { Point(0, 0, 0.25), Point(4, 0, 0.25), Point(0, 4, 0.25) };
    this->axis.cells.triangles = { { 0, 1, 2 } };
  }

  MorphometryIngredients measured(const std::optional<Box>& bounds = {}, double margin = 0) const
  {
    medial::PolarBalls samples; // without balls
    samples.samples = this->mesh.points;
    samples.spacing = 0.1;
    return medial::ingredients(
      { samples, this->axis, this->mesh.points, this->triangles }, bounds, margin);
  }
};

MorphometryIngredients complete()
{
  MorphometryIngredients result = Plate().measured();
  result.volume.thickness = medial::distribution({ 0.4, 0.6 });
  result.volume.separation = medial::distribution({ 0.9, 1.1 });
  result.isShell = true;
  result.plateShare = 0.75;
  result.rodShare = 0.25;
  result.plates = 8;
  result.rods = 27;
  result.plateThickness = result.rodThickness = 0.5;
  result.plateWidth = 2;
  result.plateArea = 4;
  result.rodLength = 3;
  result.plateJunctions = result.mixedJunctions = 16;
  result.rodJunctions = 8;
  return result;
}
}

TEST(Morphometry, OfNothingIsUnknown)
{
  const std::vector<double> values = medial::morphometry({});
  ASSERT_EQ(values.size(), allQuantities().size());
  for (const double value : values)
  {
    EXPECT_TRUE(std::isnan(value));
  }
  EXPECT_TRUE(medial::morphometryWarnings({}).empty());
}

TEST(Morphometry, NamesEachQuantityOnce)
{
  std::set<std::string> names;
  for (const Quantity& quantity : allQuantities())
  {
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
    EXPECT_EQ(quantity.description[std::strlen(quantity.description) - 1], '.');
    EXPECT_TRUE(quantity.power >= -3 && quantity.power <= 3);
  }
}

TEST(Morphometry, OfAPlateIsKnown)
{
  const MorphometryIngredients plate = complete();
  for (const double value : medial::morphometry(plate))
  {
    EXPECT_TRUE(std::isfinite(value));
  }
  EXPECT_NEAR(valueOf("TV", plate), 8, 1e-9);
  EXPECT_NEAR(valueOf("BV", plate), 7.5, 1e-9);
  EXPECT_NEAR(valueOf("BV/TV", plate), 7.5 / 8, 1e-9);
  EXPECT_NEAR(valueOf("BS", plate), 40, 1e-9);
  EXPECT_NEAR(valueOf("BS/BV", plate), 40 / 7.5, 1e-9);
  EXPECT_EQ(valueOf("Euler", plate), 0);
  EXPECT_NEAR(valueOf("Euler.VOI", plate), 0, 1e-12);
  EXPECT_NEAR(valueOf("Conn.D", plate), 1.0 / 8, 1e-9);
  EXPECT_NEAR(valueOf("Conn.D.VOI", plate), 1.0 / 8, 1e-9);
  EXPECT_NEAR(valueOf("pTb.N", plate), 1, 1e-9);
  EXPECT_NEAR(valueOf("rTb.N", plate), 1.5, 1e-9);
  EXPECT_NEAR(valueOf("Tb.NA", plate), 1, 1e-9); // half of a square of 4 x 4
  EXPECT_NEAR(valueOf("Spacing/Tb.Th", plate), 0.2, 1e-9);
}

TEST(Morphometry, OfAVolumeThatCutsHasNoUncorrectedConnectivity)
{
  const MorphometryIngredients cut = Plate().measured({}, 0.125);
  EXPECT_NEAR(valueOf("TV", cut), 3.75 * 3.75 * 0.25, 1e-9);
  EXPECT_NEAR(valueOf("BV", cut), (3.75 * 3.75 - 1) * 0.25, 1e-9);
  EXPECT_NEAR(valueOf("BS", cut), 4 * 0.25, 1e-9); // the hole's
  EXPECT_TRUE(std::isnan(valueOf("Conn.D", cut)));
  EXPECT_NEAR(valueOf("Euler.VOI", cut), 0, 1e-12);
  EXPECT_NEAR(valueOf("Conn.D.VOI", cut), 1 / valueOf("TV", cut), 1e-9);
  const Box around(Point(-1, -1, -1), Point(5, 5, 2));
  EXPECT_NEAR(valueOf("Conn.D", Plate().measured(around)), 1 / around.volume(), 1e-9);
}

/// One piece around one void, and nothing else that has a void or a hole.
TEST(Morphometry, KnowsShells)
{
  const auto isShell = [](const meshes::Mesh& mesh) {
    Plate plate;
    plate.mesh = meshes::triangulated(mesh);
    plate.triangles = meshes::triangles(plate.mesh);
    return plate.measured().isShell;
  };
  const meshes::Mesh hollow =
    meshes::united(meshes::sphere(), meshes::reversed(meshes::sphere(0.5)));
  const meshes::Mesh beside = meshes::moved(meshes::sphere(), Point(3, 0, 0));
  EXPECT_TRUE(isShell(hollow));
  EXPECT_FALSE(isShell(meshes::sphere()));
  EXPECT_FALSE(isShell(meshes::torus()));
  EXPECT_FALSE(isShell(meshes::united(hollow, beside)));
  EXPECT_FALSE(isShell(meshes::united(meshes::torus(), meshes::reversed(meshes::torus(2, 0.3)))));
  MorphometryIngredients solid = complete();
  EXPECT_EQ(valueOf("Ct.Th", solid), valueOf("Tb.Th", solid));
  solid.isShell = false;
  EXPECT_TRUE(std::isnan(valueOf("Ct.Th", solid)));
}

TEST(Morphometry, OfAnOpenSurfaceHasNoVolume)
{
  Plate plate;
  plate.triangles.pop_back();
  const MorphometryIngredients open = plate.measured();
  for (const char* name : { "BV", "BV/TV", "BS/BV", "Euler", "Conn.D", "Conn.D.VOI" })
  {
    EXPECT_TRUE(std::isnan(valueOf(name, open))) << name;
  }
  EXPECT_GT(valueOf("BS", open), 0);
  EXPECT_GT(valueOf("TV", open), 0);
}

/// Lengths grow with the unit as their powers say.
TEST(Morphometry, HasTheUnitsOfItsTable)
{
  Plate large;
  large.mesh = meshes::scaled(large.mesh, 10);
  large.axis.points = { Point(0, 0, 2.5), Point(40, 0, 2.5), Point(0, 40, 2.5) };
  MorphometryIngredients big = large.measured(), small = complete();
  big.spacing *= 10;
  big.volume.thickness = medial::distribution({ 4, 6 });
  big.volume.separation = medial::distribution({ 9, 11 });
  big.isShell = true;
  for (double MorphometryIngredients::*length :
    { &MorphometryIngredients::plateThickness, &MorphometryIngredients::rodThickness,
      &MorphometryIngredients::plateWidth, &MorphometryIngredients::rodLength })
  {
    big.*length = 10 * small.*length;
  }
  big.plateArea = 100 * small.plateArea;
  for (double MorphometryIngredients::*number : { &MorphometryIngredients::plateShare,
         &MorphometryIngredients::rodShare, &MorphometryIngredients::plates,
         &MorphometryIngredients::rods, &MorphometryIngredients::plateJunctions,
         &MorphometryIngredients::mixedJunctions, &MorphometryIngredients::rodJunctions })
  {
    big.*number = small.*number;
  }
  for (const Quantity& quantity : allQuantities())
  {
    const double expected = std::pow(10, quantity.power) * quantity.value(small);
    EXPECT_NEAR(quantity.value(big), expected, 1e-9 * (1 + std::abs(expected))) << quantity.name;
  }
}

TEST(Morphometry, SaysTheUnit)
{
  const auto unit = [](int power, const char* length) {
    return medial::unitOf(Quantity{ "", power, "", "", nullptr }, length);
  };
  EXPECT_EQ(unit(3, "mm"), "mm^3");
  EXPECT_EQ(unit(1, "mm"), "mm");
  EXPECT_EQ(unit(-1, "um"), "um^-1");
  EXPECT_EQ(unit(0, "mm"), "1");
  EXPECT_EQ(unit(2, ""), "unit^2");
}

TEST(Morphometry, WarnsOfCoarseSamples)
{
  MorphometryIngredients plate = complete();
  plate.spacing = 0.3 * plate.volume.thickness.mean;
  const medial::Warnings warnings = medial::morphometryWarnings(plate);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings.front().code, "coarse_for_thickness");
  EXPECT_FALSE(warnings.front().doubtsSolid);
  plate.spacing = 0.25 * plate.volume.thickness.mean;
  EXPECT_TRUE(medial::morphometryWarnings(plate).empty());
}
