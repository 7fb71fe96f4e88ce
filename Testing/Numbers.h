// SPDX-License-Identifier: BSD-3-Clause
#ifndef Numbers_h
#define Numbers_h

#include "Base/Types.h"

#include <random>

/// Numbers that are the same to the last bit under every compiler, optimisation and library: distributions
/// of the standard library differ, sines too, and Eigen adds up in the order that suits the processor.
namespace shapes
{
using medial::Point;
using Random = std::mt19937;

double uniform(Random& random, double from, double to);

/// In the box about the origin with this corner.
Point uniformInBox(Random& random, const Point& corner);

/// Of length 1.
Point direction(Random& random);

/// Nearly normal, with mean 0: a sum of twelve uniform numbers, never beyond six deviations.
double normal(Random& random, double deviation);

Point normalPoint(Random& random, double deviation);

/// Right to 1e-15 for angles of a few turns.
double sine(double angle);
double cosine(double angle);

double dot(const Point& a, const Point& b);
double length(const Point& vector);
Point unit(const Point& vector);
}

#endif
