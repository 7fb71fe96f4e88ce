// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/PointVolumes.h"

namespace medial
{
std::vector<double> pointVolumes(const MedialAxis& axis)
{
  std::vector<Index> pointOfBall(axis.ballOwner.size(), None);
  for (Index p = count(axis.points) - 1; p >= 0; --p)
  {
    if (axis.ballOfPoint[p] != None)
    {
      pointOfBall[axis.ballOfPoint[p]] = p;
    }
  }
  std::vector<double> result(axis.points.size(), 0);
  for (Index ball = 0; ball < count(axis.ballOwner); ++ball)
  {
    const Index owner = axis.ballOwner[ball];
    if (owner != None && pointOfBall[owner] != None)
    {
      result[pointOfBall[owner]] += axis.ballVolumes[ball];
    }
  }
  return result;
}
}
