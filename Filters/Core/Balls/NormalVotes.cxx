// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/NormalVotes.h"

#include "Base/Errors.h"

#include <algorithm>
#include <optional>

namespace medial
{
namespace
{
/// Makes a direction of a normal, or zero where it has none.
Point directionOf(const Point& normal)
{
  const double largest = normal.cwiseAbs().maxCoeff();
  // Dividing by the largest component first, neither tiny nor huge normals leave the range of doubles.
  return normal.allFinite() && largest > 0 ? Point((normal / largest).normalized()) : Point::Zero();
}

/// 1 where the ball is in front of the sample's normal, -1 behind, 0 not known.
Index vote(const Point& normal, const Point& sample, const Ball& ball)
{
  const double height = normal.dot(ball.center - sample);
  return height > 0 ? 1 : height < 0 ? -1 : 0;
}

/// How samples with a pole that is surely outside vote on the farther one of these poles.
struct Poll
{
  Index outside = 0;
  Index inside = 0;
};

Poll pollOfOutside(
  const std::vector<Point>& normals, const DistinctSamples& distinct, const SideInput& input)
{
  const std::vector<char> known = surelyOutside(input);
  const auto isKnown = [&](Index b) { return b != None && known[b]; };
  Poll result;
  for (std::size_t s = 0; s < distinct.points.size(); ++s)
  {
    const auto& poles = input.ballsOfSample[s];
    const auto pole = std::find_if(poles.begin(), poles.end(), isKnown);
    if (pole != poles.end())
    {
      const Index one = vote(normals[distinct.ids[s]], distinct.points[s], input.balls[*pole]);
      result.outside += one > 0 ? 1 : 0;
      result.inside += one < 0 ? 1 : 0;
    }
  }
  return result;
}

Warnings unusable(const std::vector<Point>& normals)
{
  const auto isNone = [](const Point& normal) { return directionOf(normal).isZero(); };
  const auto none = std::count_if(normals.begin(), normals.end(), isNone);
  if (none == 0)
  {
    return {};
  }
  return { { "unusable_normals",
    text(none, " of ", normals.size(),
      " normals are zero or not finite. Their samples count as samples without a normal."),
    static_cast<Index>(none), {}, false } };
}

Warning inverted(Index sampleCount)
{
  return { "inverted_normals",
    "The normals point into the solid: on most of its outside they do. All were turned around. "
    "Give normals that point outwards.",
    sampleCount, {}, false };
}

Warning unoriented(const Poll& poll)
{
  return { "unoriented_normals",
    text("Of the normals on the outside of the samples ", poll.outside, " point outwards and ",
      poll.inside, " inwards, so no normals were used. Orient all normals outwards."),
    std::min(poll.outside, poll.inside), {}, false };
}

/// The samples' places by their numbers in the input, in the frame.
std::vector<Point> placesOf(const DistinctSamples& distinct)
{
  std::vector<Point> result(distinct.duplicateOf.size(), Point::Zero());
  for (std::size_t s = 0; s < distinct.ids.size(); ++s)
  {
    result[distinct.ids[s]] = distinct.points[s];
  }
  return result;
}
}

std::vector<Point> distinctNormals(
  const std::vector<Point>& normals, const DistinctSamples& distinct)
{
  std::vector<Point> result(normals.size(), Point::Zero());
  for (Index i = 0; i < count(normals); ++i)
  {
    const Index first = distinct.duplicateOf[i];
    result[first == None ? i : first] += directionOf(normals[i]);
  }
  std::transform(result.begin(), result.end(), result.begin(), directionOf);
  return result;
}

NormalVotes normalVotes(const std::vector<Point>& normals, const DistinctSamples& distinct,
  const IndexLists& ballSamples, const SideInput& input)
{
  if (normals.size() != distinct.duplicateOf.size())
  {
    throw InvalidInput("there are ", normals.size(), " normals for ", distinct.duplicateOf.size(),
      " samples; give one for each, or none");
  }
  NormalVotes result{ distinctNormals(normals, distinct), {}, unusable(normals) };
  const Poll poll = pollOfOutside(result.normals, distinct, input);
  // On sharp edges, where a normal may be that of one face, some votes are wrong.
  constexpr Index mostWrong = 10;
  if (mostWrong * std::min(poll.outside, poll.inside) > poll.outside + poll.inside)
  {
    result.warnings.push_back(unoriented(poll));
    return result;
  }
  if (poll.inside > poll.outside)
  {
    result.warnings.push_back(inverted(count(normals)));
    std::transform(result.normals.begin(), result.normals.end(), result.normals.begin(),
      [](const Point& normal) -> Point { return -normal; });
  }
  const std::vector<Point> places = placesOf(distinct);
  result.ofBall.assign(input.balls.size(), 0);
  for (Index b = 0; b < count(input.balls); ++b)
  {
    for (const Index s : ballSamples[b])
    {
      result.ofBall[b] += vote(result.normals[s], places[s], input.balls[b]);
    }
  }
  return result;
}

Warnings normalWarnings(const NormalVotes& votes, const DistinctSamples& distinct,
  const SideInput& input, const std::vector<Side>& sides)
{
  if (votes.ofBall.empty())
  {
    return {};
  }
  Index contradicting = 0;
  std::optional<Point> place;
  for (std::size_t s = 0; s < distinct.points.size(); ++s)
  {
    const auto isContradicted = [&](Index b) {
      const Index wrong = b == None || sides[b] == Side::Hidden ? 0
        : sides[b] == Side::Inner                               ? 1
                                                                : -1;
      return wrong != 0 &&
        vote(votes.normals[distinct.ids[s]], distinct.points[s], input.balls[b]) == wrong;
    };
    const auto& [first, second] = input.ballsOfSample[s];
    if (isContradicted(first) || isContradicted(second))
    {
      ++contradicting;
      place = place ? place : distinct.frame.toWorld(distinct.points[s]);
    }
  }
  const Index total = count(distinct.points);
  if (100 * contradicting <= total)
  {
    return {};
  }
  const bool doubtsSolid = 20 * contradicting > total;
  return { { "contradicting_normals",
    text("The normals of ", contradicting, " of ", total,
      " samples say that a ball is on the other side than the normals around it. Orient the "
      "normals alike; sample sharp edges and thin walls more densely."),
    contradicting, place, doubtsSolid } };
}
}
