// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Base/Lists.h"
#include "Parts/TopologyGraph.h"

#include <algorithm>
#include <set>

using complexes::Drawing;
using medial::ContactCurve;
using medial::Index;
using medial::IndexLists;
using medial::MedialAxis;
using medial::MedialParts;
using medial::None;
using medial::Point;
using medial::TopologyGraph;
using pipelines::Pipeline;

namespace
{
TopologyGraph graphOf(const Drawing& drawing)
{
  const MedialAxis axis = drawing.axis();
  const MedialParts parts = medial::decompose(axis);
  return medial::topologyGraph(parts.contacts, medial::count(parts.parts), axis.points);
}

std::vector<Index> listed(IndexLists::View list)
{
  return std::vector<Index>(list.begin(), list.end());
}

Index total(const std::vector<char>& flags)
{
  return static_cast<Index>(std::count(flags.begin(), flags.end(), 1));
}

/// Nodes and parts that can be reached from `start` (nodes first, then parts) without `closed`.
std::set<Index> reached(const TopologyGraph& graph, Index start, Index closed)
{
  const Index nodes = graph.partsOfNode.size();
  std::set<Index> seen{ start };
  for (std::vector<Index> todo{ start }; !todo.empty();)
  {
    const Index at = todo.back();
    todo.pop_back();
    for (const Index other : at < nodes ? graph.partsOfNode[at] : graph.nodesOfPart[at - nodes])
    {
      const Index next = at < nodes ? nodes + other : other;
      if (next != closed && seen.insert(next).second)
      {
        todo.push_back(next);
      }
    }
  }
  return seen;
}

/// A part is on a loop if and only if one of its nodes can be reached from another without it.
bool isOnLoop(const TopologyGraph& graph, Index part)
{
  const IndexLists::View own = graph.nodesOfPart[part];
  const Index closed = graph.partsOfNode.size() + part;
  for (const Index a : own)
  {
    const std::set<Index> from = reached(graph, a, closed);
    for (const Index b : own)
    {
      if (a != b && from.count(b))
      {
        return true;
      }
    }
  }
  return false;
}

void expectConsistent(const MedialAxis& axis, const MedialParts& parts)
{
  const TopologyGraph graph =
    medial::topologyGraph(parts.contacts, medial::count(parts.parts), axis.points);
  ASSERT_EQ(graph.nodesOfPart.size(), medial::count(parts.parts));
  ASSERT_EQ(graph.nodeCentroids.size(), static_cast<std::size_t>(graph.partsOfNode.size()));
  for (std::size_t a = 0; a < parts.contacts.size(); ++a)
  {
    const ContactCurve& curve = parts.contacts[a];
    EXPECT_EQ(graph.nodeOfContact[a] == None, curve.parts.size() < 2);
    for (const Index part : curve.parts)
    {
      const std::vector<Index> nodes = listed(graph.nodesOfPart[part]);
      EXPECT_TRUE(curve.parts.size() < 2 ||
        std::binary_search(nodes.begin(), nodes.end(), graph.nodeOfContact[a]));
    }
    for (std::size_t b = 0; b < a; ++b)
    {
      const std::vector<Index>& other = parts.contacts[b].points;
      const bool connected = std::find_first_of(other.begin(), other.end(), curve.points.begin(),
                               curve.points.end()) != other.end();
      EXPECT_TRUE(!connected || curve.parts.size() < 2 || parts.contacts[b].parts.size() < 2 ||
        graph.nodeOfContact[a] == graph.nodeOfContact[b]);
    }
  }
  for (Index part = 0; part < graph.nodesOfPart.size(); ++part)
  {
    EXPECT_EQ(graph.partOnLoop[part] != 0, isOnLoop(graph, part)) << "part " << part;
    for (const Index node : graph.nodesOfPart[part])
    {
      const std::vector<Index> back = listed(graph.partsOfNode[node]);
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), part));
    }
  }
}
}

TEST(TopologyGraph, OfFigure7LeftHasOneNodeAndNoLoop)
{
  const TopologyGraph graph = graphOf(complexes::cycleWithoutLoop()); // Figure 8, left
  ASSERT_EQ(graph.partsOfNode.size(), 1);
  EXPECT_EQ(listed(graph.partsOfNode[0]), (std::vector<Index>{ 0, 1, 2 }));
  EXPECT_EQ(total(graph.partOnLoop), 0);
  EXPECT_EQ(total(graph.nodeOnLoop), 0);
  EXPECT_TRUE(graph.nodeCentroids[0].isApprox(Point(0, 0, 1.5)));
}

TEST(TopologyGraph, OfFigure7RightHasALoopOfThreeNodes)
{
  const TopologyGraph graph = graphOf(complexes::cycleWithLoop()); // Figure 8, right; and fins
  ASSERT_EQ(graph.partsOfNode.size(), 3);
  EXPECT_EQ(graph.nodeOnLoop, (std::vector<char>{ 1, 1, 1 }));
  EXPECT_EQ(graph.partOnLoop, (std::vector<char>{ 1, 1, 1, 0, 0, 0 }));
  for (Index part = 0; part < 6; ++part)
  {
    EXPECT_EQ(graph.nodesOfPart[part].size(), part < 3 ? 2 : 1) << "part " << part;
  }
}

TEST(TopologyGraph, OfFigure9HasFourNodesAndSixParts)
{
  const TopologyGraph graph = graphOf(complexes::fourNodesAndSixParts());
  ASSERT_EQ(graph.partsOfNode.size(), 4);
  ASSERT_EQ(graph.nodesOfPart.size(), 6);
  std::set<std::vector<Index>> joined;
  for (Index part = 0; part < 6; ++part)
  {
    EXPECT_EQ(graph.nodesOfPart[part].size(), 2);
    joined.insert(listed(graph.nodesOfPart[part]));
  }
  EXPECT_EQ(joined.size(), 6u) << "a part between each two nodes";
  EXPECT_EQ(total(graph.nodeOnLoop), 4);
  EXPECT_EQ(total(graph.partOnLoop), 6);
}

TEST(TopologyGraph, JoinsCurvesThatMeetInAPoint)
{
  // A box's thirteen parts touch along twelve curves that meet at the corners of the middle sheet.
  const TopologyGraph graph = graphOf(complexes::boxAxis());
  EXPECT_EQ(graph.partsOfNode.size(), 1);
  EXPECT_EQ(graph.nodesOfPart.size(), 13);
  EXPECT_EQ(total(graph.partOnLoop), 0);
}

TEST(TopologyGraph, HasNodesWherePartsTouchInPoints)
{
  // A sheet, a bridge of one line, a sheet; and a line that comes back to the first sheet.
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 1, 1);
  drawing.sheet(Point(5, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 1, 1);
  drawing.edge(drawing.point(1, 0, 0), drawing.point(5, 0, 0));
  drawing.edge(drawing.point(0, 0, 0), drawing.point(0, 0, 3));
  drawing.edge(drawing.point(0, 0, 3), drawing.point(0, 1, 0));
  const TopologyGraph graph = graphOf(drawing);
  ASSERT_EQ(graph.partsOfNode.size(), 4);
  EXPECT_EQ(graph.partOnLoop, (std::vector<char>{ 1, 0, 0, 1 }));
  EXPECT_EQ(total(graph.nodeOnLoop), 2);
}

TEST(TopologyGraph, LeavesOutWhatIsGone)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  const MedialParts parts = medial::decompose(axis);
  const TopologyGraph open = medial::topologyGraph(parts.contacts, { 1, 0, 0, 0, 0, 0 });
  EXPECT_EQ(total(open.partOnLoop), 0);
  EXPECT_EQ(open.nodesOfPart[0].size(), 0);
  const TopologyGraph sheets = medial::topologyGraph(parts.contacts, { 0, 0, 0, 1, 1, 1 });
  EXPECT_EQ(total(sheets.partOnLoop), 3);
  const TopologyGraph one = medial::topologyGraph(parts.contacts, { 0, 1, 1, 1, 1, 1 });
  EXPECT_EQ(one.partsOfNode.size(), 0);
}

TEST(TopologyGraph, OfRandomComplexesAndShapesFitsTheirContacts)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    expectConsistent(axis, medial::decompose(axis));
  }
  expectConsistent(pipelines::of("box").pruned().axis, pipelines::of("box").pruned().parts);
  expectConsistent(pipelines::of("knot").pruned().axis, pipelines::of("knot").pruned().parts);
}
