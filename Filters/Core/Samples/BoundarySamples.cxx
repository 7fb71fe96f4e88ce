// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/BoundarySamples.h"

#include "Base/EdgeTree.h"
#include "Base/Neighbors.h"
#include "Samples/PairedWalls.h"
#include "Samples/SharpEdges.h"

#include <algorithm>
#include <cmath>

// Coarse samples measure the thickness around them, which gives a spacing everywhere; samples with that
// spacing measure it again. What is thinner than the first ones could see is seen by those. This is
// repeated until the spacing stays.
namespace medial
{
namespace
{
Warning thinWalls(const std::vector<Point>& places)
{
  return { "paired_walls",
    text("Walls or gaps are too narrow for their samples. In ", places.size(),
      places.size() == 1 ? " place" : " places",
      " these come in pairs instead, so that the topology is right; but balls there are as wide as "
      "the samples are "
      "apart, not as the walls. Take a smaller spacing where radii matter."),
    count(places), places.front(), false };
}

/// Where the thickness was measured, and the spacing that it asks for.
struct Probes
{
  std::vector<Point> places;
  std::vector<double> spacings;
};

EdgeTree treeOf(const TriangleSet& triangles, const std::vector<SharpLine>& lines)
{
  std::vector<Edge> edges;
  for (const SharpLine& line : lines)
  {
    for (const SharpEdge& edge : line)
    {
      edges.push_back(edge.ends);
    }
  }
  return EdgeTree(triangles.points, edges);
}
}

struct BoundarySampler::Implementation
{
  Implementation(const ClosedSurface& surface, const SurfaceTree& theTree,
    const SamplingOptions& theOptions, const Execution& execution)
    : triangles(triangleSet(surface.points, surface.triangles))
    , tree(theTree)
    , options(theOptions)
    , lines(sharpLines(triangles, theOptions.sharpAngle))
    , sharpEdges(treeOf(triangles, lines))
    , largest(theOptions.spacing > 0
          ? std::max(theOptions.spacing, closestSpacing(surface, theOptions))
          : usualSpacing(surface))
    , edges(wedgeEdges(this->triangles, this->lines, this->largest))
    , field(this->largest)
  {
    if (this->options.adaptive)
    {
      this->adapt(execution);
    }
    else
    {
      this->limit(execution);
    }
  }

  /// Measures the thickness and fills the field. After the first two rounds only where it has become much finer.
  void adapt(const Execution& execution)
  {
    constexpr double coarse = 2; // times the largest spacing: a quarter of the samples
    constexpr int rounds = 3;
    SpacingField before(coarse * this->largest);
    this->pieces = surfacePieces(this->triangles, before, execution.between(0, 0.05));
    std::vector<SurfacePoint> at;
    this->measure(smallPieces(this->triangles, before.most()));
    this->measure(this->details);
    for (int round = 0; round < rounds; ++round)
    {
      const Execution part =
        execution.between((round + 0.1) / double(rounds), (round + 1) / double(rounds));
      const Index known = count(at);
      const std::vector<SurfacePoint> more =
        blueNoise(this->triangles, this->pieces, {}, before, part.between(0, 0.5));
      at.insert(at.end(), more.begin(), more.end());
      const Index finer = this->measure(at, known, before, part.between(0.5, 1));
      this->updateField(part);
      constexpr double few = 0.001; // of the samples: the next round would hardly differ
      if (round + 1 == rounds || (round > 0 && finer <= few * count(at)))
      {
        break;
      }
      this->pieces.erase(std::remove_if(this->pieces.begin(), this->pieces.end(),
                           [&](const SurfacePiece& piece) {
                             return !isMuchFiner(piece.spacing, before, piece.middle());
                           }),
        this->pieces.end());
      before = this->field;
    }
  }

  /// Pairs on both sides of narrow wedges were not enough: measures how thin these are.
  void sampleWedgesAsWalls(const Execution& execution)
  {
    constexpr double wide = 120; // between the normals
    this->edges.clear();
    this->lines = sharpLines(this->triangles, this->options.sharpAngle, wide);
    if (this->options.adaptive)
    {
      this->probes = {};
      this->adapt(execution);
    }
  }

  static bool isMuchFiner(double spacing, const SpacingField& before, const Point& place)
  {
    constexpr double much = 0.7;
    return spacing < much * before.most() && spacing < much * before.at(place);
  }

  /// The spacing that a thickness asks for. Walls come as close as one likes at the tip of a wedge or in a fold; samples
  /// don't, and more of them would leave more places where the walls are not told apart. So what would need
  /// a spacing below the smallest is not followed; around it the spacing is small anyway.
  double wanted(double thickness) const
  {
    const double asked = this->options.fineness * thickness;
    return asked < this->smallest() ? this->largest : std::min(asked, this->largest);
  }

  double smallest() const { return this->largest / 64; }

  /// Walls that are nearer are not followed: samples come in pairs there.
  double tooNarrow() const
  {
    return this->options.adaptive ? this->smallest() / this->options.fineness : 0;
  }

  /// Adds what is measured straight across at details: flat triangles around a corner are no opposite walls of each
  /// other. However thin they are, they are followed where that takes few samples.
  void measure(const std::vector<Detail>& at)
  {
    for (const Detail& detail : at)
    {
      const double thickness = localThickness({ detail.place }, this->tree, this->triangles.normals,
        this->largest / this->options.fineness, this->edges)[0];
      constexpr double few = 1000; // samples of them all
      const double asked = this->options.fineness * thickness;
      const bool isCheap = samplesPerSquare * detail.area < few * asked * asked;
      this->probes.places.push_back(detail.place.position);
      this->probes.spacings.push_back(
        isCheap ? std::min(asked, this->largest) : this->wanted(thickness));
    }
  }

  /// Adds what is measured at samples from the first on. @return  how many ask for much less than the spacing was
  Index measure(const std::vector<SurfacePoint>& at, Index first, const SpacingField& before,
    const Execution& execution)
  {
    const std::vector<double> thickness = localThickness(at, this->tree, this->triangles.normals,
      this->largest / this->options.fineness, this->edges, execution, first);
    Index finer = 0;
    for (std::size_t i = 0; i < thickness.size(); ++i)
    {
      const Point& place = at[first + i].position;
      this->probes.places.push_back(place);
      this->probes.spacings.push_back(this->wanted(thickness[i]));
      finer += isMuchFiner(this->probes.spacings.back(), before, place);
    }
    return finer;
  }

  /// The points of the surface next to a place, on both sides of it.
  std::vector<SurfacePoint> around(const Point& place) const
  {
    const auto pointAt = [this](const SurfaceTree::Place& on) {
      return SurfacePoint{ on.point, this->triangles.normals[on.triangle], on.triangle };
    };
    const SurfaceTree::Place foot = this->tree.nearest(place);
    std::vector<SurfacePoint> result{ pointAt(foot) };
    constexpr double far = 4; // spacings: what is opposite in a wedge is nearer
    const Point away = (place - foot.point).normalized() * far * this->field.at(place);
    if (const auto opposite = this->tree.firstMet(place, place + away, None))
    {
      result.push_back(pointAt(this->tree.nearest(opposite->point)));
    }
    return result;
  }

  /// The spacing that all probes ask for, as far as there is room.
  void updateField(const Execution& execution)
  {
    this->field = SpacingField(
      this->largest, this->probes.places, this->probes.spacings, execution.between(0, 0));
    this->limit(execution);
  }

  /// Widens the smallest spacings until there is room for all samples.
  void limit(const Execution& execution)
  {
    double least = 0;
    if (this->options.spacing > 0 && this->options.spacing < this->largest)
    {
      least = this->largest;
      this->field = this->field.atLeast(least);
    }
    this->pieces = surfacePieces(this->triangles, this->field, execution);
    while (expectedSamples(this->pieces) > this->options.maximumSamples)
    {
      least = std::max(1.2 * least, this->smallest());
      this->field = this->field.atLeast(least);
      this->pieces = surfacePieces(this->triangles, this->field, execution);
    }
    this->warnings.clear();
    if (least > 0)
    {
      this->warnings.push_back({ "too_many_samples",
        text("Samples are nowhere closer than ", least, ", so that there are not more than ",
          this->options.maximumSamples,
          ". Thin places may be wrong: allow more samples, or sample a part of the surface."),
        1, this->field.tightest(), true });
    }
  }

  TriangleSet triangles;
  const SurfaceTree& tree;
  SamplingOptions options;
  std::vector<SharpLine> lines; ///< with pairs
  EdgeTree sharpEdges;          ///< all
  double largest;
  std::vector<WedgeEdge> edges;
  Probes probes;
  std::vector<Detail> details; ///< that were missed before
  SpacingField field;
  std::vector<SurfacePiece> pieces; ///< by the field
  bool isRefined = false;           ///< once at least
  Warnings warnings;
};

BoundarySampler::BoundarySampler(const ClosedSurface& surface, const SurfaceTree& tree,
  const SamplingOptions& options, const Execution& execution)
{
  check(options);
  checkLength(surface);
  this->implementation = std::make_unique<Implementation>(surface, tree, options, execution);
}

BoundarySampler::~BoundarySampler() = default;

BoundarySamples BoundarySampler::samples(const Execution& execution) const
{
  const Implementation& known = *this->implementation;
  const std::vector<SurfacePoint> pairs =
    mirroredSamples(known.triangles, known.tree, known.field, known.lines);
  BoundarySamples result;
  result.mirrored = count(pairs);
  PairedSamples paired =
    pairAcrossWalls(known.triangles, known.tree, known.field, known.tooNarrow(),
      blueNoise(known.triangles, known.pieces, pairs, known.field, execution.between(0, 0.8)),
      result.mirrored, execution.between(0.8, 0.9));
  result.points = std::move(paired.points);
  result.spacings.resize(result.points.size());
  execution.between(0.9, 1).forEach(count(result.points),
    [&](Index i) { result.spacings[i] = known.field.at(result.points[i].position); });
  result.warnings = known.warnings;
  if (!paired.places.empty())
  {
    result.warnings.push_back(thinWalls(paired.places));
  }
  return result;
}

std::vector<Detail> BoundarySampler::spikes(
  const BoundarySamples& samples, const Execution& execution) const
{
  const Implementation& known = *this->implementation;
  return medial::spikes(known.triangles, samples.points, known.field, execution);
}

std::vector<Detail> BoundarySampler::hiddenDetails(
  const BoundarySamples& samples, const Execution& execution) const
{
  const Implementation& known = *this->implementation;
  std::vector<Detail> result = barePieces(known.triangles, samples.points);
  const std::vector<Detail> hidden = hiddenSides(known.triangles, samples.points, execution);
  result.insert(result.end(), hidden.begin(), hidden.end());
  return result;
}

Index BoundarySampler::follow(const std::vector<Detail>& details, const Execution& execution)
{
  Implementation& known = *this->implementation;
  if (!known.options.adaptive || details.empty())
  {
    return 0;
  }
  const Index before = count(known.probes.places);
  known.details.insert(known.details.end(), details.begin(), details.end());
  known.measure(details);
  Index closer = 0;
  for (Index i = before; i < count(known.probes.places); ++i)
  {
    constexpr double much = 0.9;
    closer += known.probes.spacings[i] < much * known.field.at(known.probes.places[i]);
  }
  if (closer > 0)
  {
    known.updateField(execution);
  }
  return closer;
}

bool BoundarySampler::isAtSharpEdge(const Point& place, double distance) const
{
  return this->implementation->sharpEdges.distance(place) < distance;
}

Index BoundarySampler::add(const std::vector<Point>& places, BoundarySamples& samples, double apart,
  const MoreNeighbors& present) const
{
  const Implementation& known = *this->implementation;
  std::vector<SurfacePoint> found;
  for (const Point& place : places)
  {
    const std::vector<SurfacePoint> around = known.around(place);
    found.insert(found.end(), around.begin(), around.end());
  }
  const std::vector<Point> at = positions(found);
  const Neighbors candidates(at);
  const Index before = count(samples.points);
  std::vector<char> isAdded(found.size(), 0);
  for (Index i = 0; i < count(found); ++i)
  {
    const double spacing = known.field.at(at[i]), near = apart * spacing;
    const std::vector<Index> around = candidates.within(i, near);
    const Point& nearest = samples.points[present.nearestOne(at[i])].position;
    if ((nearest - at[i]).norm() >= near &&
      std::none_of(around.begin(), around.end(), [&](Index other) { return isAdded[other]; }))
    {
      isAdded[i] = 1;
      samples.points.push_back(found[i]);
      samples.spacings.push_back(spacing);
    }
  }
  return count(samples.points) - before;
}

void BoundarySampler::refine(const std::vector<Point>& places, const Execution& execution)
{
  Implementation& known = *this->implementation;
  // A few spots, such as the end of an edge, become right that way at once, or not; many of them in wedges don't.
  constexpr double few = 0.005; // of the samples; a spot has about five places
  constexpr double always = 100;
  const bool areMany = count(places) > std::max(few * expectedSamples(known.pieces), always);
  if (!known.edges.empty() && (areMany || known.isRefined))
  {
    known.sampleWedgesAsWalls(execution);
  }
  known.isRefined = true;
  for (const Point& place : places)
  {
    known.probes.places.push_back(place);
    known.probes.spacings.push_back(known.field.at(place) / 2);
  }
  known.updateField(execution);
}
}
