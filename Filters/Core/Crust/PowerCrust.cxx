// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/PowerCrust.h"

#include "Balls/PowerShape.h"
#include "Base/DisjointSets.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Triangulations.h"
#include "Crust/CrustSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace medial
{
namespace
{
void requireValid(
  const PolarBalls& polarBalls, const std::vector<char>& keep, const CrustOptions& options)
{
  if (!keep.empty() && keep.size() != polarBalls.balls.size())
  {
    throw InvalidInput("the axis belongs to other balls: it knows ", keep.size(), ", there are ",
      polarBalls.balls.size(), "; give the balls that the axis was made of");
  }
  if (!(polarBalls.spacing > 0))
  {
    throw InvalidInput("the balls have no sample spacing; give the output of Polar Balls");
  }
  if (!(options.clearance > 0) || options.maximumRounds < 0)
  {
    throw InvalidInput("the clearance must be larger than 0 sample spacings, and the number of "
                       "rounds not negative");
  }
}

/// Which balls make the crust.
struct ChosenBalls
{
  std::vector<Index> ids; ///< into PolarBalls
  PowerDiagram diagram;   ///< without its dual
};

/// The outer balls of the samples of removed inner balls (CrustRule::InnerAndOuter).
std::vector<char> outerBallsOfRemoved(const PolarBalls& polarBalls, const std::vector<char>& keep)
{
  std::vector<char> result(polarBalls.balls.size(), 0);
  for (std::size_t s = 0; s < polarBalls.samples.size(); ++s)
  {
    const Index inner = polarBalls.innerBall[s], outer = polarBalls.outerBall[s];
    if (inner != None && outer != None && !keep[inner] && !polarBalls.touchesGuard[outer])
    {
      result[outer] = 1;
    }
  }
  return result;
}

ChosenBalls chosenBalls(const PolarBalls& polarBalls, const std::vector<char>& keep,
  const CrustOptions& options, const Frame& frame)
{
  std::vector<char> dropped(polarBalls.balls.size(), 0);
  if (options.rule == CrustRule::InnerAndOuter && !keep.empty())
  {
    dropped = outerBallsOfRemoved(polarBalls, keep);
  }
  ChosenBalls result;
  PowerDiagram& diagram = result.diagram;
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    const bool inner = polarBalls.sides[b] == Side::Inner;
    const bool removed = inner ? !keep.empty() && !keep[b] : dropped[b] != 0;
    if (polarBalls.sides[b] == Side::Hidden || removed)
    {
      continue;
    }
    result.ids.push_back(b);
    // As in the triangulation, so that power vertices are where its cells say.
    diagram.balls.push_back(jittered(frame.toLocal(polarBalls.balls[b]), b));
    diagram.inner.push_back(inner);
    const IndexLists::View samples = polarBalls.ballSamples[b];
    diagram.samples.items.insert(diagram.samples.items.end(), samples.begin(), samples.end());
    diagram.samples.close();
  }
  if (std::find(diagram.inner.begin(), diagram.inner.end(), 1) == diagram.inner.end())
  {
    throw InvalidInput(
      "no inner ball is left, so there is no surface: prune less, and give the axis "
      "that was made of these balls");
  }
  for (const Point& sample : polarBalls.samples)
  {
    diagram.positions.push_back(frame.toLocal(sample));
  }
  return result;
}

/// Betti numbers of the power shape of the kept balls.
Betti topologyOf(const PolarBalls& polarBalls, const std::vector<char>& keep)
{
  std::vector<char> kept(polarBalls.balls.size());
  for (std::size_t b = 0; b < kept.size(); ++b)
  {
    kept[b] = polarBalls.sides[b] == Side::Inner && (keep.empty() || keep[b]);
  }
  return markedBetti(withNeighbors(polarBalls.cells), kept);
}

/// The same numbers for the cells as in the input where nothing was removed.
Tetrahedra renumbered(const PolarBalls& polarBalls, const std::vector<Index>& ids)
{
  std::vector<Index> number(polarBalls.balls.size(), None);
  for (Index i = 0; i < count(ids); ++i)
  {
    number[ids[i]] = i;
  }
  std::vector<Tetrahedron> cells = polarBalls.cells;
  for (Tetrahedron& cell : cells)
  {
    for (Index& ball : cell)
    {
      ball = number[ball];
    }
  }
  return withNeighbors(std::move(cells));
}

/// Distance of a point to the union of the inner balls; 0 and less inside.
double clearance(const PowerDiagram& diagram, const Point& x)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < diagram.balls.size(); ++b)
  {
    if (diagram.inner[b])
    {
      least = std::min(least, (x - diagram.balls[b].center).norm() - diagram.balls[b].radius);
    }
  }
  return least;
}

/// The clearance of each power vertex between both sides that is no sample, else 0. What is less than
/// `limit` by the balls of its own cell may be given too large, but stays below `limit`.
std::vector<double> clearances(
  const PowerDiagram& diagram, double limit, const Execution& execution)
{
  std::vector<double> result(diagram.dual.cells.size(), 0);
  execution.forEach(count(result), [&](Index c) {
    bool inner = false, outer = false;
    double least = std::numeric_limits<double>::infinity();
    for (const Index b : diagram.dual.cells[c])
    {
      inner = inner || diagram.inner[b];
      outer = outer || !diagram.inner[b];
      if (diagram.inner[b])
      {
        least = std::min(
          least, (diagram.vertices[c] - diagram.balls[b].center).norm() - diagram.balls[b].radius);
      }
    }
    if (inner && outer && diagram.sampleOfVertex[c] == None)
    {
      result[c] = std::max(0.0, least > limit ? clearance(diagram, diagram.vertices[c]) : least);
    }
  });
  return result;
}

/// Balls that fill what is farther than `limit` from the inner balls, largest first, none centred in
/// another one (rule G).
std::vector<Ball> fillingBalls(
  const PowerDiagram& diagram, const std::vector<double>& clearances, double limit)
{
  std::vector<Index> order;
  for (Index c = 0; c < count(clearances); ++c)
  {
    if (clearances[c] > limit)
    {
      order.push_back(c);
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return clearances[a] > clearances[b]; });
  constexpr std::size_t roundLimit = 5000; // each is compared with all of its round
  std::vector<Ball> result;
  for (const Index c : order)
  {
    if (result.size() == roundLimit)
    {
      break;
    }
    const Point& center = diagram.vertices[c];
    if (std::none_of(result.begin(), result.end(),
          [&](const Ball& ball) { return (center - ball.center).norm() < ball.radius; }))
    {
      result.push_back({ center, clearances[c] });
    }
  }
  return result;
}

/// The power vertices that pruning has not touched: their cells were there before.
class UntouchedCells
{
public:
  /// @param ids  the balls that are left, in the diagram's order
  UntouchedCells(const std::vector<Tetrahedron>& before, const std::vector<Index>& left)
    : cells(before)
    , ids(left)
  {
    for (Tetrahedron& cell : this->cells)
    {
      std::sort(cell.begin(), cell.end());
    }
    std::sort(this->cells.begin(), this->cells.end());
  }

  bool contains(Tetrahedron cell) const
  {
    for (Index& ball : cell)
    {
      if (ball >= count(this->ids))
      {
        return false; // was inserted
      }
      ball = this->ids[ball];
    }
    std::sort(cell.begin(), cell.end());
    return std::binary_search(this->cells.begin(), this->cells.end(), cell);
  }

private:
  std::vector<Tetrahedron> cells;
  const std::vector<Index>& ids;
};

/// What filling the clearance came to.
struct Filling
{
  int rounds = 0;
  Index inserted = 0;
  Index refused = 0;
};

/// Fills the space between the crust and the clearance from the inner balls with outer balls, as long
/// as the topology stays (rule G).
class Refiner
{
public:
  /// @param topology  the Betti numbers that the crust's solid should have
  Refiner(PowerDiagram& power, RegularTriangulation& cells, const UntouchedCells& kept,
    double clearance, const Betti& topology, const Execution& how)
    : diagram(power)
    , triangulation(cells)
    , untouched(kept)
    , limit(clearance)
    , execution(how)
    , wanted(topology)
    , defect(bettiDistance(markedBetti(power.dual, power.inner), topology))
  {
  }

  Filling run(int maximumRounds)
  {
    for (bool changed = true; changed && this->filling.rounds < maximumRounds;)
    {
      std::vector<double> distances = clearances(this->diagram, this->limit, this->execution);
      this->forgetUntouched(distances);
      const std::vector<Ball> balls = fillingBalls(this->diagram, distances, this->limit);
      this->filling.refused = 0;
      const Index before = this->filling.inserted;
      this->insert(balls);
      changed = this->filling.inserted > before;
      if (changed)
      {
        findVertices(this->triangulation.tetrahedra(), this->diagram, this->execution);
        ++this->filling.rounds;
      }
    }
    return this->filling;
  }

private:
  void forgetUntouched(std::vector<double>& distances) const
  {
    for (Index c = 0; c < count(distances); ++c)
    {
      if (distances[c] > this->limit && this->untouched.contains(this->diagram.dual.cells[c]))
      {
        distances[c] = 0;
      }
    }
  }

  /// Inserts all the balls; where that brings the topology farther from the one wanted, as many as
  /// it can by halves.
  void insert(const std::vector<Ball>& balls)
  {
    if (balls.empty())
    {
      return;
    }
    RegularTriangulation trial = this->triangulation.copy();
    trial.insert(balls, this->execution);
    std::vector<char> inner = this->diagram.inner;
    inner.resize(inner.size() + balls.size(), 0);
    const Index trialDefect = bettiDistance(markedBetti(trial.tetrahedra(), inner), this->wanted);
    if (trialDefect <= this->defect)
    {
      this->defect = trialDefect;
      this->triangulation = std::move(trial);
      this->diagram.inner = std::move(inner);
      this->filling.inserted += count(balls);
      for (const Ball& ball : balls)
      {
        this->diagram.balls.push_back(ball);
        this->diagram.samples.close();
      }
    }
    else if (balls.size() == 1)
    {
      ++this->filling.refused;
    }
    else
    {
      const auto middle = balls.begin() + static_cast<std::ptrdiff_t>(balls.size() / 2);
      this->insert({ balls.begin(), middle });
      this->insert({ middle, balls.end() });
    }
  }

  PowerDiagram& diagram;
  RegularTriangulation& triangulation;
  const UntouchedCells& untouched;
  double limit;
  const Execution& execution;
  Betti wanted;
  Index defect;
  Filling filling;
};

/// Largest clearance of the points that are no samples. The ball behind a face bounds it, so the
/// others need to be asked only where that bound is the largest left.
double largestClearance(const PowerDiagram& diagram, const Crust& crust, const Execution& execution)
{
  std::vector<double> bound(crust.points.size(), 0);
  for (Index face = 0; face < crust.faces.size(); ++face)
  {
    const Ball& ball = diagram.balls[crust.innerBall[face]];
    for (const Index p : crust.faces[face])
    {
      const double distance = (crust.points[p] - ball.center).norm() - ball.radius;
      const bool first = bound[p] == 0 || distance < bound[p];
      bound[p] = crust.sampleOfPoint[p] != None ? 0 : first ? distance : bound[p];
    }
  }
  std::vector<Index> order(crust.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return bound[a] > bound[b]; });
  double largest = 0;
  for (const Index p : order)
  {
    execution.report(0.9);
    if (bound[p] <= largest)
    {
      break;
    }
    largest = std::max(largest, clearance(diagram, crust.points[p]));
  }
  return largest;
}

/// Are all edges between two triangles, in opposite directions; do the triangles at each point form
/// one fan?
void checkSurface(Crust& crust)
{
  std::unordered_map<std::uint64_t, Index> halfEdges; // -> triangle
  const auto key = [](Index a, Index b) {
    return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint64_t>(b);
  };
  crust.closed = true;
  const auto side = [&](Index face, int k) {
    const IndexLists::View t = crust.faces[face];
    return std::make_pair(t[k], t[(k + 1) % 3]);
  };
  for (Index face = 0; face < crust.faces.size(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = side(face, k);
      crust.closed = halfEdges.insert({ key(a, b), face }).second && crust.closed;
    }
  }
  // Corner 3 * face + k; corners at one point are joined across edges.
  DisjointSets fans(3 * crust.faces.size());
  for (Index face = 0; face < crust.faces.size(); ++face)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [a, b] = side(face, k);
      const auto opposite = halfEdges.find(key(b, a));
      if (opposite == halfEdges.end())
      {
        crust.closed = false;
        continue;
      }
      const IndexLists::View other = crust.faces[opposite->second];
      for (int j = 0; j < 3; ++j)
      {
        if (other[j] == a)
        {
          fans.unite(3 * face + k, 3 * opposite->second + j);
        }
      }
    }
  }
  std::vector<Index> fanAt(crust.points.size(), None);
  crust.manifold = crust.closed;
  for (Index corner = 0; corner < count(crust.faces.items); ++corner)
  {
    Index& fan = fanAt[crust.faces.items[corner]];
    fan = fan == None ? fans.find(corner) : fan;
    crust.manifold = crust.manifold && fan == fans.find(corner);
  }
}

/// Volume and Betti numbers of what is enclosed: of the surface's pieces those of positive volume are
/// outer boundaries, the others boundaries of voids.
void measureSolid(Crust& crust)
{
  const Index n = count(crust.points);
  DisjointSets pieces(n);
  std::vector<Index> euler(n, 0);
  std::vector<double> volume(n, 0);
  std::vector<char> used(n, 0);
  for (Index face = 0; face < crust.faces.size(); ++face)
  {
    const IndexLists::View t = crust.faces[face];
    pieces.unite(t[0], t[1]);
    pieces.unite(t[0], t[2]);
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  for (Index face = 0; face < crust.faces.size(); ++face)
  {
    const IndexLists::View t = crust.faces[face];
    const Point &a = crust.points[t[0]], &b = crust.points[t[1]], &c = crust.points[t[2]];
    volume[pieces.find(t[0])] += a.cross(b).dot(c) / 6;
    euler[pieces.find(t[0])] -= 1; // doubled: one face, three halves of an edge
  }
  for (Index p = 0; p < n; ++p)
  {
    euler[pieces.find(p)] += used[p] ? 2 : 0;
  }
  crust.betti = { 0, 0, 0 };
  crust.volume = std::accumulate(volume.begin(), volume.end(), 0.0);
  for (Index p = 0; p < n; ++p)
  {
    if (used[p] && pieces.find(p) == p)
    {
      ++crust.betti[volume[p] > 0 ? 0 : 2];
      crust.betti[1] += (4 - euler[p]) / 4; // genus = (2 - chi) / 2
    }
  }
}
}

Crust powerCrust(const PolarBalls& polarBalls, const std::vector<char>& keep,
  const CrustOptions& options, const Execution& execution)
{
  requireValid(polarBalls, keep, options);
  const Frame frame = frameOf(polarBalls.samples);
  ChosenBalls chosen = chosenBalls(polarBalls, keep, options, frame);
  PowerDiagram& diagram = chosen.diagram;
  const double spacing = polarBalls.spacing * frame.scale;
  const std::size_t visible = std::count_if(polarBalls.sides.begin(), polarBalls.sides.end(),
    [](Side side) { return side != Side::Hidden; });
  RegularTriangulation triangulation;
  const bool pruned = chosen.ids.size() < visible;
  if (pruned)
  {
    triangulation.insert(diagram.balls, execution.part(0, 0.6));
  }
  findVertices(
    pruned ? triangulation.tetrahedra() : renumbered(polarBalls, chosen.ids), diagram, execution);
  Filling filling;
  if (pruned && options.rule == CrustRule::Clearance)
  {
    const Execution refinement = execution.part(0.6, 0.8);
    const UntouchedCells untouched(polarBalls.cells, chosen.ids);
    const Betti topology = options.topology ? *options.topology : topologyOf(polarBalls, keep);
    filling =
      Refiner(diagram, triangulation, untouched, options.clearance * spacing, topology, refinement)
        .run(options.maximumRounds);
  }
  execution.report(0.8);
  Crust crust = crustSurface(diagram);
  checkSurface(crust);
  measureSolid(crust);
  crust.insertedBalls = filling.inserted;
  crust.refusedBalls = filling.refused;
  crust.rounds = filling.rounds;
  crust.maximumClearance = largestClearance(diagram, crust, execution) / spacing;
  crust.volume /= frame.scale * frame.scale * frame.scale;
  for (std::size_t p = 0; p < crust.points.size(); ++p)
  {
    const Index sample = crust.sampleOfPoint[p];
    crust.points[p] = sample != None ? polarBalls.samples[sample] : frame.toWorld(crust.points[p]);
  }
  const auto original = [&](Index& ball) {
    ball = ball < count(chosen.ids) ? chosen.ids[ball] : None;
  };
  std::for_each(crust.innerBall.begin(), crust.innerBall.end(), original);
  std::for_each(crust.outerBall.begin(), crust.outerBall.end(), original);
  execution.report(1);
  return crust;
}
}
