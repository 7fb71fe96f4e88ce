// SPDX-License-Identifier: BSD-3-Clause
#include "Validators.h"

#include "Base/Lists.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace validators
{
namespace
{
using Corners = std::vector<Index>;
using Columns = std::vector<Corners>;

/// All simplices of a complex by dimension, corners ascending, sorted, each once.
using Skeleton = std::array<Columns, 4>;

template <typename Simplices>
void append(Columns& to, const Simplices& simplices)
{
  for (const auto& simplex : simplices)
  {
    Corners corners(simplex.begin(), simplex.end());
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
    {
      throw std::invalid_argument("a simplex with a repeated corner");
    }
    to.push_back(std::move(corners));
  }
}

/// What is listed, without faces and with repetitions.
Skeleton listed(const Complex& complex)
{
  Skeleton result;
  for (const Index vertex : complex.vertices)
  {
    result[0].push_back({ vertex });
  }
  append(result[1], complex.edges);
  append(result[2], complex.triangles);
  append(result[3], complex.tetrahedra);
  return result;
}

void sortUnique(Columns& columns)
{
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
}

Corners without(const Corners& simplex, std::size_t corner)
{
  Corners face = simplex;
  face.erase(face.begin() + static_cast<std::ptrdiff_t>(corner));
  return face;
}

Skeleton closure(const Complex& complex)
{
  Skeleton result = listed(complex);
  for (std::size_t dimension = 3; dimension > 0; --dimension)
  {
    sortUnique(result[dimension]);
    for (const Corners& simplex : result[dimension])
    {
      for (std::size_t corner = 0; corner < simplex.size(); ++corner)
      {
        result[dimension - 1].push_back(without(simplex, corner));
      }
    }
  }
  sortUnique(result[0]);
  return result;
}

/// One column for each simplex: the numbers of its faces, ascending.
Columns boundaryMatrix(const Columns& simplices, const Columns& faces)
{
  Columns matrix;
  for (const Corners& simplex : simplices)
  {
    Corners column;
    for (std::size_t corner = 0; corner < simplex.size(); ++corner)
    {
      const auto found = std::lower_bound(faces.begin(), faces.end(), without(simplex, corner));
      column.push_back(static_cast<Index>(found - faces.begin()));
    }
    std::sort(column.begin(), column.end());
    matrix.push_back(std::move(column));
  }
  return matrix;
}

/// Rank over Z/2: columns are added until their last entries differ.
Index rank(Columns matrix, std::size_t rowCount)
{
  std::vector<Index> columnOfLast(rowCount, None);
  Index result = 0;
  Corners sum;
  for (std::size_t j = 0; j < matrix.size(); ++j)
  {
    Corners& column = matrix[j];
    while (!column.empty() && columnOfLast[column.back()] != None)
    {
      const Corners& other = matrix[columnOfLast[column.back()]];
      sum.clear();
      std::set_symmetric_difference(
        column.begin(), column.end(), other.begin(), other.end(), std::back_inserter(sum));
      column.swap(sum);
    }
    if (!column.empty())
    {
      columnOfLast[column.back()] = static_cast<Index>(j);
      ++result;
    }
  }
  return result;
}

using EdgeUses = std::map<Edge, std::vector<Index>>;

EdgeUses trianglesOfEdges(const std::vector<Triangle>& triangles)
{
  EdgeUses uses;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      uses[undirected(triangles[t][i], triangles[t][(i + 1) % 3])].push_back(static_cast<Index>(t));
    }
  }
  return uses;
}

}

Betti bettiNumbers(const Complex& complex)
{
  const Skeleton skeleton = closure(complex);
  std::array<Index, 5> ranks{ 0, 0, 0, 0, 0 }; // of the boundary of simplices by dimension
  for (std::size_t d = 1; d < 4; ++d)
  {
    ranks[d] = rank(boundaryMatrix(skeleton[d], skeleton[d - 1]), skeleton[d - 1].size());
  }
  Betti betti;
  for (std::size_t d = 0; d < 3; ++d)
  {
    betti[d] = medial::count(skeleton[d]) - ranks[d] - ranks[d + 1];
  }
  return betti;
}

Index eulerCharacteristic(const Complex& complex)
{
  const Skeleton skeleton = closure(complex);
  return medial::count(skeleton[0]) - medial::count(skeleton[1]) + medial::count(skeleton[2]) -
    medial::count(skeleton[3]);
}

Index repeatedSimplices(const Complex& complex)
{
  Index repeated = 0;
  for (Columns& simplices : listed(complex))
  {
    const std::size_t before = simplices.size();
    sortUnique(simplices);
    repeated += static_cast<Index>(before - simplices.size());
  }
  return repeated;
}

Index unusedPoints(Index pointCount, const Complex& complex)
{
  std::vector<char> used(static_cast<std::size_t>(pointCount), 0);
  for (const Columns& simplices : listed(complex))
  {
    for (const Corners& simplex : simplices)
    {
      for (const Index corner : simplex)
      {
        used.at(static_cast<std::size_t>(corner)) = 1;
      }
    }
  }
  return static_cast<Index>(std::count(used.begin(), used.end(), 0));
}

std::vector<Index> floodFill(const std::vector<Triangle>& triangles)
{
  const EdgeUses uses = trianglesOfEdges(triangles);
  std::vector<Index> labels(triangles.size(), None);
  Index label = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed)
  {
    if (labels[seed] != None)
    {
      continue;
    }
    std::vector<Index> open{ static_cast<Index>(seed) };
    labels[seed] = label;
    while (!open.empty())
    {
      const Triangle triangle = triangles[open.back()];
      open.pop_back();
      for (int i = 0; i < 3; ++i)
      {
        const auto& both = uses.at(undirected(triangle[i], triangle[(i + 1) % 3]));
        for (const Index next : both)
        {
          if (both.size() == 2 && labels[next] == None)
          {
            labels[next] = label;
            open.push_back(next);
          }
        }
      }
    }
    ++label;
  }
  return labels;
}

std::vector<int> levels(const std::vector<Triangle>& triangles, const std::vector<Index>& labels)
{
  const Index labelCount = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
  std::vector<int> result(static_cast<std::size_t>(labelCount), 0);
  std::set<Edge> neighbours;
  for (const auto& [edge, around] : trianglesOfEdges(triangles))
  {
    if (around.size() == 1)
    {
      result[labels[around[0]]] = 1;
    }
    for (const Index a : around)
    {
      for (const Index b : around)
      {
        neighbours.insert({ labels[a], labels[b] });
      }
    }
  }
  bool changed = true;
  for (int level = 1; changed; ++level)
  {
    changed = false;
    for (const Edge& pair : neighbours)
    {
      if (result[pair[0]] == level && result[pair[1]] == 0)
      {
        result[pair[1]] = level + 1;
        changed = true;
      }
    }
  }
  return result;
}

bool sameGroups(const std::vector<Index>& a, const std::vector<Index>& b)
{
  if (a.size() != b.size())
  {
    return false;
  }
  std::map<Index, Index> there, back;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    if (there.emplace(a[i], b[i]).first->second != b[i] ||
      back.emplace(b[i], a[i]).first->second != a[i])
    {
      return false;
    }
  }
  return true;
}
}
