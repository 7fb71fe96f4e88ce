// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/FarSpots.h"

#include "Base/DisjointSets.h"

#include <algorithm>

namespace medial
{
FarSpots::FarSpots(const std::vector<FarFace>& theFaces, double theWanted, double reach)
  : faces(theFaces)
  , wanted(theWanted)
  , places(placesOf(theFaces))
  , neighbors(this->places)
  , spotOfFace(theFaces.size())
{
  DisjointSets joined(count(this->faces));
  for (Index f = 0; f < count(this->faces); ++f)
  {
    for (const Index other : this->neighbors.within(f, 2 * reach * this->faces[f].spacing))
    {
      joined.unite(f, other);
    }
  }
  for (Index f = 0; f < count(this->faces); ++f)
  {
    const Index first = joined.find(f);
    if (first == f)
    {
      this->spotOfFace[f] = count(this->spots);
      this->spots.emplace_back();
    }
    this->spotOfFace[f] = this->spotOfFace[first];
    this->spots[this->spotOfFace[f]].best.left.push_back(this->faces[f]);
  }
  for (FarSpot& spot : this->spots)
  {
    spot.tried = spot.best;
  }
}

std::array<Index, 2> FarSpots::badness(const std::vector<FarFace>& faces, double wanted)
{
  const auto isTooFar = [wanted](const FarFace& face) { return face.distance > wanted; };
  return { static_cast<Index>(std::count_if(faces.begin(), faces.end(), isTooFar)), count(faces) };
}

std::vector<FarFace> FarSpots::unsolved() const
{
  std::vector<FarFace> result;
  for (Index f = 0; f < count(this->faces); ++f)
  {
    if (!isSolved(this->spots[this->spotOfFace[f]]))
    {
      result.push_back(this->faces[f]);
    }
  }
  return result;
}

std::vector<FarFace> FarSpots::left() const
{
  std::vector<FarFace> result;
  for (const FarSpot& spot : this->spots)
  {
    if (!isSolved(spot))
    {
      result.insert(result.end(), spot.tried.left.begin(), spot.tried.left.end());
    }
  }
  return result;
}

BoundarySamples FarSpots::with(const BoundarySamples& samples, FarAttempt FarSpot::*attempt) const
{
  BoundarySamples result = samples;
  for (const FarSpot& spot : this->spots)
  {
    const FarAttempt& added = spot.*attempt;
    result.points.insert(result.points.end(), added.points.begin(), added.points.end());
    result.spacings.insert(result.spacings.end(), added.spacings.begin(), added.spacings.end());
  }
  return result;
}

void FarSpots::add(const BoundarySamples& samples, Index first)
{
  for (Index s = first; s < count(samples.points); ++s)
  {
    FarAttempt& tried = this->spotAt(samples.points[s].position).tried;
    tried.points.push_back(samples.points[s]);
    tried.spacings.push_back(samples.spacings[s]);
  }
}

void FarSpots::judge(const std::vector<FarFace>& left)
{
  for (FarSpot& spot : this->spots)
  {
    spot.tried.left.clear();
  }
  for (const FarFace& face : left)
  {
    this->spotAt(face.place).tried.left.push_back(face);
  }
  constexpr int patience = 4; // attempts
  for (FarSpot& spot : this->spots)
  {
    if (badness(spot.tried.left, this->wanted) < badness(spot.best.left, this->wanted))
    {
      spot.best = spot.tried;
      spot.failures = 0;
    }
    else if (!isSolved(spot) && ++spot.failures % patience == 0)
    {
      spot.tried = spot.best;
    }
  }
}

bool FarSpots::isSolved(const FarSpot& spot)
{
  return spot.best.left.empty();
}

FarSpot& FarSpots::spotAt(const Point& place)
{
  return this->spots[this->spotOfFace[this->neighbors.nearestOne(place)]];
}

std::vector<Point> placesOf(const std::vector<FarFace>& faces)
{
  std::vector<Point> result(faces.size());
  std::transform(
    faces.begin(), faces.end(), result.begin(), [](const FarFace& face) { return face.place; });
  return result;
}
}
