// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/RodPieces.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{
/// The points begin ... end - 1 of a curve, all on plates or all not.
struct Run
{
  Index begin, end;
};

std::vector<Run> runs(const std::vector<char>& isPlate)
{
  std::vector<Run> result;
  for (Index i = 0; i < count(isPlate); ++i)
  {
    if (i == 0 || isPlate[i] != isPlate[i - 1])
    {
      result.push_back({ i, i });
    }
    result.back().end = i + 1;
  }
  return result;
}

/// Is a run shorter than the mean thickness along it?
bool isShort(const Centerline& curve, const std::vector<double>& at, const Run& run)
{
  double thickness = 0;
  for (Index i = run.begin; i < run.end; ++i)
  {
    thickness += 2 * curve.radii[i] / (run.end - run.begin);
  }
  return at[run.end - 1] - at[run.begin] < thickness;
}

/// For each point of a curve, is it on a plate?
std::vector<char> onPlates(const Centerline& curve, double widthRatio)
{
  std::vector<char> result;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    result.push_back(curve.halfWidths[i] > widthRatio * curve.radii[i] ? 1 : 0);
  }
  const std::vector<double> at = lengths(curve.points);
  for (const char wrong : { 1, 0 }) // short plates first
  {
    for (const Run& run : runs(result))
    {
      const bool isWhole = run.end - run.begin == count(result);
      if (result[run.begin] == wrong && !isWhole && isShort(curve, at, run))
      {
        std::fill(result.begin() + run.begin, result.begin() + run.end, wrong == 1 ? 0 : 1);
      }
    }
  }
  return result;
}

/// The same loop from its first point on a plate.
Centerline fromPlate(const Centerline& loop, double widthRatio)
{
  const std::vector<char> isPlate = onPlates(loop, widthRatio);
  const auto first = std::find(isPlate.begin(), isPlate.end(), 1) - isPlate.begin();
  Centerline result = loop;
  const auto turn = [first](auto& values) {
    values.pop_back();
    std::rotate(values.begin(), values.begin() + first % static_cast<std::ptrdiff_t>(values.size()),
      values.end());
    values.push_back(values.front());
  };
  turn(result.points);
  turn(result.radii);
  turn(result.halfWidths);
  return result;
}

Centerline pieceOf(const Centerline& curve, const Run& run)
{
  const auto part = [&run](const auto& values) {
    return std::decay_t<decltype(values)>(values.begin() + run.begin, values.begin() + run.end);
  };
  const bool isFirst = run.begin == 0, isLast = run.end == count(curve.points);
  return { part(curve.points), part(curve.radii), part(curve.halfWidths),
    { isFirst ? curve.nodes[0] : AtPlate, isLast ? curve.nodes[1] : AtPlate } };
}

/// Does a piece stay within a radius of the rim of the plate at one of its ends?
bool isRim(const Centerline& piece, bool isPlateLast)
{
  const std::size_t plate = isPlateLast ? piece.points.size() - 1 : 0;
  const double reach = piece.halfWidths[plate] + piece.radii[plate];
  for (std::size_t i = 0; i < piece.points.size(); ++i)
  {
    if ((piece.points[i] - piece.points[plate]).norm() + piece.radii[i] > reach)
    {
      return false;
    }
  }
  return true;
}
}

std::vector<Centerline> rodPieces(
  const Centerline& curve, const std::array<bool, 2>& isFree, double widthRatio)
{
  const bool isLoop = curve.nodes[0] == None;
  const Centerline line = isLoop ? fromPlate(curve, widthRatio) : curve;
  const std::vector<char> isPlate = onPlates(line, widthRatio);
  std::vector<Centerline> result;
  for (const Run& run : runs(isPlate))
  {
    if (isPlate[run.begin] || run.end - run.begin < 2)
    {
      continue;
    }
    Centerline piece = pieceOf(line, run);
    const bool isFirst = run.begin == 0, isLast = run.end == count(line.points);
    const bool isRimPiece = (isFirst && isFree[0] && !isLast && isRim(piece, true)) ||
      (isLast && isFree[1] && !isFirst && isRim(piece, false));
    if (!isRimPiece)
    {
      result.push_back(std::move(piece));
    }
  }
  return result;
}
}
