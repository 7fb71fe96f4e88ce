// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Membranes.h"

#include "Axis/FaceComplex.h"
#include "Axis/VertexMerging.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <iterator>

// The sides of each patch are sorted: O(n log n) time for n faces.

namespace medial
{
namespace
{
/// Patches: what FaceComplex::joinedFaces joins.
class Patches
{
public:
  explicit Patches(const FaceComplex& faceComplex)
    : faces(faceComplex)
    , patches(faceComplex.joinedFaces())
    , facesOfPatch(faceComplex.facesOfPieces([this](Index p) { return this->patches.find(p); }))
  {
  }

  /// Of each membrane the sides, ascending.
  std::vector<std::vector<Index>> membranes()
  {
    std::vector<std::vector<Index>> result;
    for (Index patch = 0; patch < this->facesOfPatch.size(); ++patch)
    {
      std::vector<Index> sides = this->sidesOf(patch);
      if (this->isMembrane(patch, sides))
      {
        result.push_back(std::move(sides));
      }
    }
    return result;
  }

private:
  std::vector<Index> sidesOf(Index patch) const
  {
    std::vector<Index> result;
    for (const Index p : this->facesOfPatch[patch])
    {
      const IndexLists::View sides = this->faces.sidesOf(p);
      result.insert(result.end(), sides.begin(), sides.end());
    }
    sortUnique(result);
    return result;
  }

  /// Does another patch pass by, with two faces, at each side that other faces have; or one at one side that is at all
  /// others, too? And are there as many of these sides as faces?
  bool isMembrane(Index patch, const std::vector<Index>& sides)
  {
    Index contacts = 0, passed = 0;
    std::vector<Index> atAll, passing;
    for (const Index s : sides)
    {
      if (this->faces.faceCount(s) == 2)
      {
        continue;
      }
      std::vector<Index> others = this->othersAt(s, patch);
      const std::size_t before = passing.size();
      for (std::size_t i = 1; i < others.size(); ++i)
      {
        if (others[i] == others[i - 1])
        {
          passing.push_back(others[i]);
        }
      }
      passed += passing.size() > before;
      sortUnique(others);
      atAll = contacts++ == 0 ? others : common(atAll, others);
      if (others.empty() || (passed < contacts && atAll.empty()))
      {
        return false;
      }
    }
    sortUnique(passing);
    return contacts > 0 && this->facesOfPatch[patch].size() <= contacts &&
      (passed == contacts || !common(atAll, passing).empty());
  }

  static std::vector<Index> common(const std::vector<Index>& a, const std::vector<Index>& b)
  {
    std::vector<Index> result;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result;
  }

  /// The other patches at a side, ascending, as often as they have faces there.
  std::vector<Index> othersAt(Index side, Index patch)
  {
    std::vector<Index> result;
    this->faces.forFacesAt(side, [&](Index p) {
      if (this->patches.find(p) != patch)
      {
        result.push_back(this->patches.find(p));
      }
    });
    std::sort(result.begin(), result.end());
    return result;
  }

  const FaceComplex& faces;
  DisjointSets patches;
  IndexLists facesOfPatch; ///< by the lowest face
};
}

std::vector<char> closeMembranes(const FaceGeometry& geometry, std::vector<FacePolygon>& polygons)
{
  const FaceComplex faces(polygons, count(geometry.points));
  const auto length = [&](const Edge& side) {
    return (geometry.points[side[0]] - geometry.points[side[1]]).norm();
  };
  std::vector<std::vector<Edge>> sidesOfMembranes;
  for (const std::vector<Index>& sides : Patches(faces).membranes())
  {
    sidesOfMembranes.emplace_back();
    std::vector<Edge>& own = sidesOfMembranes.back();
    std::transform(sides.begin(), sides.end(), std::back_inserter(own),
      [&faces](Index s) { return faces.ends(s); });
    std::stable_sort(own.begin(), own.end(),
      [&length](const Edge& a, const Edge& b) { return length(a) < length(b); });
  }
  return contractToEdges(sidesOfMembranes, geometry.ball, polygons);
}
}
