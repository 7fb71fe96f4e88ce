// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/ShrinkingShape.h"

#include "Base/Lists.h"
#include "Base/Tetrahedra.h"

#include <algorithm>
#include <iterator>

// The replaced cells fill a ball, whose boundary stays. A simplex is inside if no triangle of the boundary
// has it; then so are all larger ones around it.
namespace medial
{
namespace
{
/// One to four corners, ascending; before them None.
using Simplex = Tetrahedron;

/// The simplex and all its faces.
void addFaces(Simplex corners, std::vector<Simplex>& faces)
{
  std::sort(corners.begin(), corners.end());
  const auto begin = static_cast<unsigned>(std::count(corners.begin(), corners.end(), None));
  const unsigned all = (15U << begin) & 15U;
  for (unsigned subset = 1U << begin; subset <= all; subset += 1U << begin)
  {
    Simplex face{ None, None, None, None };
    std::size_t place = face.size();
    for (unsigned k = 4; k-- > begin;)
    {
      if ((subset & 1U << k) != 0)
      {
        face[--place] = corners[k];
      }
    }
    faces.push_back(face);
  }
}

/// The triangles that only one cell has.
std::vector<Triangle> boundary(const std::vector<Tetrahedron>& cells)
{
  std::vector<Triangle> all;
  for (const Tetrahedron& cell : cells)
  {
    for (int k = 0; k < 4; ++k)
    {
      all.push_back(facet(cell, k));
      std::sort(all.back().begin(), all.back().end());
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<Triangle> result;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool again =
      (i > 0 && all[i - 1] == all[i]) || (i + 1 < all.size() && all[i + 1] == all[i]);
    if (!again)
    {
      result.push_back(all[i]);
    }
  }
  return result;
}

/// The simplices of inner balls inside the replaced cells, sorted.
std::vector<Simplex> lostSimplices(
  const std::vector<Tetrahedron>& replaced, const std::vector<char>& inner)
{
  std::vector<Simplex> all, staying, result;
  for (const Tetrahedron& cell : replaced)
  {
    Simplex simplex = cell;
    for (Index& ball : simplex)
    {
      ball = ball != None && inner[ball] ? ball : None;
    }
    addFaces(simplex, all);
  }
  for (const auto& [a, b, c] : boundary(replaced))
  {
    addFaces({ None, a, b, c }, staying);
  }
  sortUnique(all);
  sortUnique(staying);
  std::set_difference(
    all.begin(), all.end(), staying.begin(), staying.end(), std::back_inserter(result));
  return result;
}

/// Collapses simplices that are inside: all that are larger around one of them are among them.
class Collapses
{
public:
  explicit Collapses(std::vector<Simplex> lost)
    : simplices(std::move(lost))
    , around(this->simplices.size(), 0)
    , sumAround(this->simplices.size(), 0)
    , gone(this->simplices.size(), 0)
  {
    for (Index s = 0; s < count(this->simplices); ++s)
    {
      this->forFacets(s, [&](Index facet) {
        ++this->around[facet];
        this->sumAround[facet] += s;
      });
    }
  }

  /// @return  are all gone?
  bool run()
  {
    std::vector<Index> free;
    for (Index s = 0; s < count(this->simplices); ++s)
    {
      this->around[s] == 1 ? free.push_back(s) : void();
    }
    Index left = count(this->simplices);
    while (!free.empty())
    {
      const Index s = free.back();
      free.pop_back();
      if (this->gone[s] || this->around[s] != 1)
      {
        continue;
      }
      for (const Index going : { this->sumAround[s], s })
      {
        this->gone[going] = 1;
        --left;
        this->forFacets(going, [&](Index facet) {
          this->sumAround[facet] -= going;
          --this->around[facet] == 1 ? free.push_back(facet) : void();
        });
      }
    }
    return left == 0;
  }

private:
  /// Those of its facets that are inside.
  template <typename Action>
  void forFacets(Index simplex, const Action& action) const
  {
    for (int k = 0; k < 4; ++k)
    {
      Simplex facet = this->simplices[simplex];
      if (facet[k] == None)
      {
        continue;
      }
      std::rotate(facet.begin(), facet.begin() + k, facet.begin() + k + 1);
      facet[0] = None;
      const auto found = std::lower_bound(this->simplices.begin(), this->simplices.end(), facet);
      if (found != this->simplices.end() && *found == facet)
      {
        action(static_cast<Index>(found - this->simplices.begin()));
      }
    }
  }

  std::vector<Simplex> simplices;
  std::vector<Index> around;    ///< how many one dimension larger have it
  std::vector<Index> sumAround; ///< of their numbers: if there is one, it is this
  std::vector<char> gone;
};
}

bool shrinksByCollapses(const std::vector<Tetrahedron>& replaced, const std::vector<char>& inner)
{
  return Collapses(lostSimplices(replaced, inner)).run();
}
}
