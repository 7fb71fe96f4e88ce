// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/SideCut.h"

#include "Base/Lists.h"

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

// The sides that contradict links of the least total strength are hard to find, since some links want opposite
// sides. So each ball has two nodes, "is outer" and "is inner" (roof duality: Boros, Hammer 2002). A node is
// true on the source's side of a cut. A link for the same side joins both "outer" and both "inner"; one for
// opposite sides joins each "outer" with the other "inner". A minimum cut then contradicts no more than any
// sides do. A ball whose two nodes agree is on that side in one of the best labellings; the others are left
// alone. Capacities are whole numbers: so the least set of true nodes is unique, and in it all that follows.
//
// With m balls and e links the graph has 2m nodes and 2e edges; the algorithm of Boykov and Kolmogorov takes
// about as long as the regular triangulation of the balls, at most a fifth of it in practice.
namespace medial
{
namespace
{
using Capacity = std::int64_t;

/// A strength of 1.
constexpr Capacity unit = 1 << 20;

/// More than all links of a ball together.
constexpr Capacity certain = Capacity(1) << 50;

/// An edge with capacities there and back.
struct Pipe
{
  int from, to;
  Capacity there, back;
};

class Network
{
public:
  explicit Network(Index ballCount)
    : balls(ballCount)
  {
  }

  void link(const SideLink& link, Capacity capacity)
  {
    this->join(outer(link.a), link.same ? outer(link.b) : inner(link.b), capacity);
    this->join(inner(link.a), link.same ? inner(link.b) : outer(link.b), capacity);
  }

  void fix(Index ball, Side side)
  {
    const bool isInner = side == Side::Inner;
    this->pipes.push_back({ this->source(), isInner ? inner(ball) : outer(ball), certain, 0 });
    this->pipes.push_back({ isInner ? outer(ball) : inner(ball), this->sink(), certain, 0 });
  }

  /// For each ball its side in a minimum cut; hidden where its nodes don't agree.
  std::vector<Side> cut() const
  {
    const std::vector<char> isTrue = this->trueNodes();
    std::vector<Side> result(this->balls, Side::Hidden);
    for (Index b = 0; b < this->balls; ++b)
    {
      if (isTrue[outer(b)] != isTrue[inner(b)])
      {
        result[b] = isTrue[inner(b)] ? Side::Inner : Side::Outer;
      }
    }
    return result;
  }

private:
  using Graph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property,
    boost::no_property, boost::no_property, int, int>;
  using GraphEdge = Graph::edge_descriptor;

  static int outer(Index ball) { return 2 * ball; }
  static int inner(Index ball) { return 2 * ball + 1; }
  int source() const { return 2 * this->balls; }
  int sink() const { return 2 * this->balls + 1; }

  void join(int a, int b, Capacity capacity)
  {
    this->pipes.push_back({ a, b, capacity, capacity });
  }

  /// Both directions of all pipes, by where they begin: pipe i is 2i and 2i + 1.
  std::vector<Index> directions() const
  {
    return listsByKey(this->sink() + 1, [this](const auto& add) {
      for (Index i = 0; i < 2 * count(this->pipes); ++i)
      {
        add(this->ends(i).first, i);
      }
    }).items;
  }

  std::pair<int, int> ends(int direction) const
  {
    const Pipe& pipe = this->pipes[direction / 2];
    return direction % 2 == 0 ? std::pair(pipe.from, pipe.to) : std::pair(pipe.to, pipe.from);
  }

  /// The nodes on the source's side of the minimum cut nearest to it.
  std::vector<char> trueNodes() const
  {
    const std::vector<Index> order = this->directions();
    const std::size_t size = order.size();
    const int nodes = 2 * this->balls + 2;
    std::vector<std::pair<int, int>> edges(size);
    std::vector<Capacity> capacities(size), rest(size);
    std::vector<int> place(size);
    for (std::size_t k = 0; k < size; ++k)
    {
      const Pipe& pipe = this->pipes[order[k] / 2];
      edges[k] = this->ends(order[k]);
      capacities[k] = order[k] % 2 == 0 ? pipe.there : pipe.back;
      place[order[k]] = static_cast<int>(k);
    }
    const Graph graph(boost::edges_are_sorted, edges.begin(), edges.end(), nodes);
    const auto [begin, end] = boost::edges(graph);
    const std::vector<GraphEdge> all(begin, end);
    std::vector<GraphEdge> reverse(size);
    for (std::size_t k = 0; k < size; ++k)
    {
      reverse[k] = all[place[order[k] ^ 1]];
    }
    std::vector<GraphEdge> predecessors(nodes);
    std::vector<boost::default_color_type> colors(nodes);
    std::vector<int> distances(nodes);
    const auto edgeNumber = boost::get(boost::edge_index, graph);
    const auto nodeNumber = boost::get(boost::vertex_index, graph);
    const auto map = [](auto& values, auto numbers) {
      return boost::make_iterator_property_map(values.begin(), numbers);
    };
    boost::boykov_kolmogorov_max_flow(graph, map(capacities, edgeNumber), map(rest, edgeNumber),
      map(reverse, edgeNumber), map(predecessors, nodeNumber), map(colors, nodeNumber),
      map(distances, nodeNumber), nodeNumber, this->source(), this->sink());
    std::vector<char> result(nodes);
    std::transform(colors.begin(), colors.end(), result.begin(),
      [](boost::default_color_type color) { return color == boost::black_color; });
    return result;
  }

  Index balls; ///< how many
  std::vector<Pipe> pipes;
};

/// The best sides where links of poles count `weight` times, by the squares of their strengths: at a sharp edge, both
/// poles of a sample can be on one side, and the sample sees them at an obtuse angle that isn't a straight one.
std::vector<Side> bestSides(const std::vector<SideLink>& links, const std::vector<char>& known,
  const std::vector<Side>& sides, double weight)
{
  Network network(count(sides));
  for (const SideLink& link : links)
  {
    const double strength = link.strength;
    network.link(link, std::llround((link.same ? strength : weight * strength * strength) * unit));
  }
  for (Index b = 0; b < count(sides); ++b)
  {
    if (known[b])
    {
      network.fix(b, sides[b]);
    }
  }
  return network.cut();
}
}

void cutSides(const std::vector<SideLink>& links, const std::vector<char>& known,
  std::vector<Side>& sides, const Execution& execution)
{
  const auto agrees = [&](const SideLink& link) {
    return (sides[link.a] == sides[link.b]) == link.same;
  };
  if (std::all_of(links.begin(), links.end(), agrees))
  {
    return;
  }
  // Which kind of link is right depends on the place: at coarsely sampled holes links of poles, in narrow gaps
  // those of balls that intersect. Where both cuts agree, it doesn't matter. The weights are measured, see README.md.
  const std::vector<Side> first = bestSides(links, known, sides, 0.5);
  execution.report(0.5);
  const std::vector<Side> second = bestSides(links, known, sides, 1.5);
  execution.report(1);
  for (std::size_t b = 0; b < sides.size(); ++b)
  {
    sides[b] = first[b] == second[b] && first[b] != Side::Hidden ? first[b] : sides[b];
  }
}
}
