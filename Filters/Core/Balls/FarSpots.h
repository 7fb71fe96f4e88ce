// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FarSpots_h
#define medial_FarSpots_h

#include "Balls/FarFaces.h"
#include "Base/Neighbors.h"
#include "Samples/BoundarySamples.h"

#include <array>
#include <vector>

namespace medial
{
/// Samples added in a spot, and the faces that are far with them.
struct FarAttempt
{
  std::vector<SurfacePoint> points;
  std::vector<double> spacings; ///< of the points
  std::vector<FarFace> left;
};

/// Far faces that are next to each other, and what was tried there.
struct FarSpot
{
  FarAttempt tried, best;
  int failures = 0; ///< attempts since the best one
};

/// Far faces in spots that are so far apart that samples added in one don't change the others. So each keeps its own
/// best attempt. Samples and faces belong to the spot of the nearest of the first far faces.
class FarSpots
{
public:
  /// @param faces   are referred to
  /// @param wanted  distance at most, in spacings
  /// @param reach   how far away a sample changes faces, in spacings
  FarSpots(const std::vector<FarFace>& faces, double wanted, double reach);

  /// How many faces are farther than wanted, and how many there are.
  static std::array<Index, 2> badness(const std::vector<FarFace>& faces, double wanted);

  /// The faces that were there first, in the spots where some are left after the best attempt.
  std::vector<FarFace> unsolved() const;

  /// Those of the last attempts in these spots.
  std::vector<FarFace> left() const;

  /// The samples and those added by an attempt in each spot.
  BoundarySamples with(const BoundarySamples& samples, FarAttempt FarSpot::*attempt) const;

  /// Tries the samples from the first on, too.
  void add(const BoundarySamples& samples, Index first);

  /// Keeps the best attempts, and begins again from them where others don't get there.
  /// @param left  the faces that are far now
  void judge(const std::vector<FarFace>& left);

private:
  static bool isSolved(const FarSpot& spot);
  FarSpot& spotAt(const Point& place);

  const std::vector<FarFace>& faces;
  double wanted;
  std::vector<Point> places; ///< of the faces
  Neighbors neighbors;
  std::vector<Index> spotOfFace;
  std::vector<FarSpot> spots;
};

std::vector<Point> placesOf(const std::vector<FarFace>& faces);
}

#endif
