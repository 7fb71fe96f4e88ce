// SPDX-License-Identifier: BSD-3-Clause
#ifndef Inputs_h
#define Inputs_h

#include "Numbers.h"

#include <functional>
#include <string>
#include <vector>

/// Samples of smooth solids, as many as are asked for. Made, not stored; the same in every run.
namespace inputs
{
using medial::Index;
using medial::Point;
using shapes::Random;

struct Input
{
  std::string name;
  std::function<Point(Random&)> draw; ///< a random point of the surface, not evenly spread
  bool mirrored; ///< each sample has a mirror image at -x: the middle sheet lies in the plane x = 0
};

const std::vector<Input>& all();

/// About `count` samples of the input's surface, evenly spread: dart throwing.
std::vector<Point> samples(const Input& input, Index count);
}

#endif
