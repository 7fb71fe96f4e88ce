// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Crowds.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
/// A name of a cell of the grid. Two cells may have the same one; their points are a crowd for nothing.
std::uint64_t nameOfCell(double x, double y, double z)
{
  const auto part = [](double value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  };
  return ((part(x) * 0x9e3779b97f4a7c15U ^ part(y)) * 0xbf58476d1ce4e5b9U) ^ part(z);
}

/// A point in a cell that it is in or near to.
struct Member
{
  std::uint64_t cell;
  Index point;
  bool operator<(const Member& other) const
  {
    return this->cell != other.cell ? this->cell < other.cell : this->point < other.point;
  }
};

/// Each used point in all cells that it is near to.
std::vector<Member> membersOfCells(
  const std::vector<Point>& points, const std::vector<char>& used, double distance)
{
  // So few points are within the distance of a border, and few that are apart share a cell.
  constexpr double width = 16;
  // Borders where a regular grid of samples has no points.
  constexpr double offset = 0.3819660112501051;
  std::vector<Member> result;
  result.reserve(points.size());
  for (Index p = 0; p < count(points); ++p)
  {
    if (!used[p])
    {
      continue;
    }
    const Point place = (points[p] / (width * distance)).array() + offset;
    const Point low = (place.array() - 1 / width).floor();
    const Eigen::Vector3i more = ((place.array() + 1 / width).floor() - low.array()).cast<int>();
    for (int i = 0; i <= more.x(); ++i)
    {
      for (int j = 0; j <= more.y(); ++j)
      {
        for (int k = 0; k <= more.z(); ++k)
        {
          result.push_back({ nameOfCell(low.x() + i, low.y() + j, low.z() + k), p });
        }
      }
    }
  }
  return result;
}

/// Drops most of those that are alone in their cell, so that few have to be sorted.
void dropLonely(std::vector<Member>& members)
{
  int bits = 6;
  while ((std::size_t(1) << bits) < 8 * members.size())
  {
    ++bits;
  }
  const auto place = [bits](
                       const Member& m) { return m.cell * 0x9e3779b97f4a7c15U >> (64 - bits); };
  std::vector<bool> once(std::size_t(1) << bits), again(once.size());
  for (const Member& member : members)
  {
    again[place(member)] = again[place(member)] || once[place(member)];
    once[place(member)] = true;
  }
  members.erase(std::remove_if(members.begin(), members.end(),
                  [&](const Member& member) { return !again[place(member)]; }),
    members.end());
}
}

IndexLists crowds(const std::vector<Point>& points, const std::vector<char>& used, double distance)
{
  std::vector<Member> members = membersOfCells(points, used, distance);
  dropLonely(members);
  std::sort(members.begin(), members.end());
  IndexLists result;
  for (std::size_t first = 0, last = 0; first < members.size(); first = last)
  {
    while (last < members.size() && members[last].cell == members[first].cell)
    {
      ++last;
    }
    for (std::size_t k = first; k < last && last - first > 1; ++k)
    {
      result.items.push_back(members[k].point);
    }
    if (last - first > 1)
    {
      result.close();
    }
  }
  return result;
}
}
