// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Sheets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace medial
{
namespace
{
constexpr double smallestSheet = 2; // square spacings

double area(const FacePolygon& polygon, const std::vector<Point>& points)
{
  const std::vector<Index>& corners = polygon.corners;
  Point sum = Point::Zero();
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    const Point& first = points[corners[0]];
    sum += (points[corners[i - 1]] - first).cross(points[corners[i]] - first);
  }
  return 0.5 * sum.norm();
}
}

Sheets::Sheets(const FaceComplex& faceComplex, const FaceGeometry& faceGeometry)
  : faces(faceComplex)
  , geometry(faceGeometry)
  , pieces(0)
{
}

void Sheets::findPieces()
{
  this->pieces = DisjointSets(count(this->faces.polygons));
  std::vector<Index> at;
  for (Index s = 0; s < this->faces.sideCount(); ++s)
  {
    at.clear();
    this->faces.forFacesAt(s, [&at](Index p) { at.push_back(p); });
    for (std::size_t i = 0; i < at.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (at.size() == 2 || !this->turns(s, at[j], at[i]))
        {
          this->pieces.unite(at[j], at[i]);
        }
      }
    }
  }
}

void Sheets::findSheets()
{
  const Index polygonCount = count(this->faces.polygons);
  std::vector<char> isIn(polygonCount);
  for (Index p = 0; p < polygonCount; ++p)
  {
    isIn[p] = this->faces.isFace(p);
  }
  if (this->areas.empty())
  {
    std::transform(this->faces.polygons.begin(), this->faces.polygons.end(),
      std::back_inserter(this->areas),
      [this](const FacePolygon& polygon) { return area(polygon, this->geometry.points); });
  }
  // Without the slivers between them, two sheets may be one, and a sheet may be a sliver.
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round)
  {
    this->findSheetsAmong(isIn);
    for (Index p = 0; p < polygonCount; ++p)
    {
      isIn[p] = isIn[p] && this->isSheet[this->pieces.find(p)];
    }
  }
}

void Sheets::findSheetsAmong(const std::vector<char>& isIn)
{
  this->pieces = DisjointSets(count(this->faces.polygons));
  std::vector<char> atBorder(this->faces.vertexCount(), 0);
  for (Index s = 0; s < this->faces.sideCount(); ++s)
  {
    Index first = None, last = None, number = 0;
    this->faces.forFacesAt(s, [&](Index p) {
      if (isIn[p])
      {
        first = number == 0 ? p : first;
        last = p;
        ++number;
      }
    });
    if (number == 2)
    {
      this->pieces.unite(first, last);
    }
    else if (number == 1)
    {
      atBorder[this->faces.ends(s)[0]] = atBorder[this->faces.ends(s)[1]] = 1;
    }
  }
  std::vector<double> areaOfPiece(this->faces.polygons.size(), 0);
  for (Index p = 0; p < count(this->faces.polygons); ++p)
  {
    areaOfPiece[this->pieces.find(p)] += isIn[p] ? this->areas[p] : 0;
  }
  const double least = smallestSheet * this->geometry.spacing * this->geometry.spacing;
  this->isSheet.assign(this->faces.polygons.size(), 0);
  for (Index p = 0; p < count(this->faces.polygons); ++p)
  {
    const std::vector<Index>& corners = this->faces.polygons[p].corners;
    if (isIn[p] && areaOfPiece[this->pieces.find(p)] > least &&
      std::none_of(corners.begin(), corners.end(), [&](Index v) { return atBorder[v]; }))
    {
      this->isSheet[this->pieces.find(p)] = 1;
    }
  }
}

std::vector<Index> Sheets::sheetsAt(Index side)
{
  std::vector<Index> sheets;
  this->faces.forFacesAt(side, [&](Index p) {
    if (this->isSheet[this->pieces.find(p)])
    {
      sheets.push_back(p);
    }
  });
  return sheets;
}

/// Cosine of the angle, seen from a vertex, by which the site that moves farther moves from one face to
/// another. The sites are paired so that they move least.
double Sheets::cosine(Index vertex, const Edge& p, const Edge& q) const
{
  const auto between = [&](Index a, Index b) {
    const Point& from = this->geometry.points[vertex];
    const Point u = this->geometry.sites[a] - from, v = this->geometry.sites[b] - from;
    return a == b ? 1 : u.dot(v) / std::sqrt(u.squaredNorm() * v.squaredNorm());
  };
  return std::max(std::min(between(p[0], q[0]), between(p[1], q[1])),
    std::min(between(p[0], q[1]), between(p[1], q[0])));
}

bool Sheets::turns(Index side, Index p, Index q) const
{
  const Index a = this->faces.polygons[p].siteEdge, b = this->faces.polygons[q].siteEdge;
  if (a == None || b == None)
  {
    return false;
  }
  const Edge &ofP = this->geometry.siteEdges[a], &ofQ = this->geometry.siteEdges[b];
  const Edge& ends = this->faces.ends(side);
  // All sites of a vertex are equally far from it: at 60 degrees two of them are as far from each other.
  constexpr double cosineOf60Degrees = 0.5;
  return std::min(this->cosine(ends[0], ofP, ofQ), this->cosine(ends[1], ofP, ofQ)) <
    cosineOf60Degrees;
}

bool Sheets::isTripod(Index side, const std::vector<Index>& facesAtSide) const
{
  std::vector<Index> turning;
  for (const Index p : facesAtSide)
  {
    if (std::all_of(
          turning.begin(), turning.end(), [&](Index q) { return this->turns(side, p, q); }))
    {
      turning.push_back(p);
    }
  }
  return turning.size() > 2;
}

bool Sheets::isSeam(Index side)
{
  return this->faces.faceCount(side) > 2 && this->isTripod(side, this->sheetsAt(side));
}
}
