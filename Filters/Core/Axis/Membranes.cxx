// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Membranes.h"

#include "Axis/FaceComplex.h"
#include "Axis/VertexMerging.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <iterator>

// Patches are found in linear time; what is sorted, the sides of a patch and of a membrane, is short.

namespace medial
{
namespace
{
/// Patches: faces joined over sides with exactly two.
class Patches
{
public:
  explicit Patches(const FaceComplex& faceComplex)
    : faces(faceComplex)
    , patches(count(faceComplex.polygons))
  {
    for (Index s = 0; s < this->faces.sideCount(); ++s)
    {
      if (this->faces.faceCount(s) == 2)
      {
        const std::vector<Index> at = this->faces.facesAt(s);
        this->patches.unite(at[0], at[1]);
      }
    }
    this->facesOfPatch = listsByKey(count(this->faces.polygons), [&](const auto& add) {
      for (Index p = 0; p < count(this->faces.polygons); ++p)
      {
        if (this->faces.isFace(p))
        {
          add(this->patches.find(p), p);
        }
      }
    });
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

  /// Does another patch pass by at each side that other faces have, and are there as many of these sides as faces?
  bool isMembrane(Index patch, const std::vector<Index>& sides)
  {
    Index contacts = 0;
    for (const Index s : sides)
    {
      if (this->faces.faceCount(s) != 2)
      {
        if (!this->passesBy(patch, s))
        {
          return false;
        }
        ++contacts;
      }
    }
    return contacts > 0 && this->facesOfPatch[patch].size() <= contacts;
  }

  /// Has another patch two faces at the side?
  bool passesBy(Index patch, Index side)
  {
    std::vector<Index> others;
    this->faces.forFacesAt(side, [&](Index p) { others.push_back(this->patches.find(p)); });
    others.erase(std::remove(others.begin(), others.end(), patch), others.end());
    std::sort(others.begin(), others.end());
    return std::adjacent_find(others.begin(), others.end()) != others.end();
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
