// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/SideCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{
using medial::Index;
using medial::Side;
using medial::SideLink;

/// The strength of the links that sides contradict.
double contradicted(const std::vector<SideLink>& links, const std::vector<Side>& sides)
{
  double result = 0;
  for (const SideLink& link : links)
  {
    result += (sides[link.a] == sides[link.b]) == link.same ? 0 : link.strength;
  }
  return result;
}

std::vector<Side> cut(
  const std::vector<SideLink>& links, std::vector<Side> sides, const std::vector<char>& known)
{
  medial::cutSides(links, known, sides);
  return sides;
}

constexpr Side Outer = Side::Outer, Inner = Side::Inner;

TEST(SideCut, TurnsABallThatMostLinksSpeakAgainst)
{
  // 0 and 1 are known; 2 has the strongest link to 0, but more to 1.
  const std::vector<SideLink> links = { { 0, 2, 0.6F, true }, { 1, 2, 0.5F, true },
    { 1, 2, 0.5F, true }, { 0, 1, 1, false } };
  EXPECT_EQ(
    cut(links, { Outer, Inner, Outer }, { 1, 1, 0 }), std::vector<Side>({ Outer, Inner, Inner }));
}

TEST(SideCut, TurnsAGroupOfBalls)
{
  // A ring that is tied together more than to the side it is on.
  std::vector<SideLink> links;
  std::vector<Side> sides = { Outer, Inner };
  for (Index b = 2; b < 12; ++b)
  {
    links.push_back({ b, b == 11 ? 2 : b + 1, 1, true });
    links.push_back({ 0, b, 0.2F, true });
    links.push_back({ 1, b, 0.3F, true });
    sides.push_back(Outer);
  }
  std::vector<char> known(12, 0);
  known[0] = known[1] = 1;
  const std::vector<Side> result = cut(links, sides, known);
  EXPECT_EQ(std::count(result.begin(), result.end(), Inner), 11);
}

TEST(SideCut, LeavesABallWhereTheKindsOfLinksDisagree)
{
  const std::vector<SideLink> links = { { 0, 1, 1, true }, { 0, 1, 1, false } };
  EXPECT_EQ(cut(links, { Outer, Outer }, { 1, 0 }), std::vector<Side>({ Outer, Outer }));
  EXPECT_EQ(cut(links, { Outer, Inner }, { 1, 0 }), std::vector<Side>({ Outer, Inner }));
}

TEST(SideCut, WeighsPolesThatASampleSeesAtAnObtuseAngleLess)
{
  // As at the sharp rim of a hole: both poles of many samples are outside, at an angle of 134 degrees.
  std::vector<SideLink> links(20, { 0, 1, 0.7F, false });
  links.insert(links.end(), 15, { 0, 1, 1, true });
  EXPECT_EQ(cut(links, { Outer, Inner }, { 1, 0 }), std::vector<Side>({ Outer, Outer }));
}

TEST(SideCut, KeepsKnownSidesAndBallsWithoutLinks)
{
  const std::vector<SideLink> links = { { 0, 1, 1, true } };
  const std::vector<Side> sides = { Outer, Inner, Inner };
  EXPECT_EQ(cut(links, sides, { 1, 1, 0 }), sides);
}

/// Random links of one kind: both cuts are the same.
std::vector<SideLink> randomLinks(Index balls, std::mt19937& random)
{
  std::vector<SideLink> result;
  for (int i = 0; i < 3 * balls; ++i)
  {
    const Index a = static_cast<Index>(random() % balls), b = static_cast<Index>(random() % balls);
    if (a != b)
    {
      result.push_back({ a, b, static_cast<float>(1 + random() % 1000) / 1000, true });
    }
  }
  return result;
}

TEST(SideCut, IsTheBestOfAllSides)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    constexpr Index balls = 12;
    std::mt19937 random(seed);
    const std::vector<SideLink> links = randomLinks(balls, random);
    std::vector<char> known(balls, 0);
    known[0] = known[1] = 1;
    std::vector<Side> start(balls, Outer);
    start[1] = Inner;
    double least = contradicted(links, start);
    for (unsigned bits = 0; bits < 1U << (balls - 2); ++bits)
    {
      std::vector<Side> sides = start;
      for (Index b = 2; b < balls; ++b)
      {
        sides[b] = (bits >> (b - 2) & 1U) != 0 ? Inner : Outer;
      }
      least = std::min(least, contradicted(links, sides));
    }
    EXPECT_NEAR(contradicted(links, cut(links, start, known)), least, 1e-4);
  }
}
}
