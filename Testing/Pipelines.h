// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pipelines_h
#define Pipelines_h

#include "Axis/MedialAxis.h"
#include "Axis/SingularPoints.h"
#include "Balls/PolarBalls.h"
#include "Balls/PowerShape.h"
#include "Base/Lists.h"
#include "Complexes.h"
#include "Crust/PowerCrust.h"
#include "Executions.h"
#include "Parts/BallShares.h"
#include "Parts/MedialParts.h"
#include "Pruning/Pruning.h"
#include "Shapes.h"
#include "Validators.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

/// The stages of a shape, each made when first asked for and kept for the other tests.
namespace pipelines
{
using medial::Index;
using medial::IndexLists;
using medial::None;
using medial::Point;

/// Removes slivers, then features of up to a hundredth and a tenth of the volume.
inline medial::PruneOptions standardSchedule()
{
  medial::PruneOptions options;
  options.schedule = medial::parseSchedule("t5 t5 v1% v10%");
  return options;
}

/// For each ball: does it count for a part that is there?
inline std::vector<char> keptBalls(const medial::MedialAxis& axis, const medial::MedialParts& parts)
{
  std::vector<char> keep;
  for (const Index part : medial::partOfBall(axis, parts.partOfCell))
  {
    keep.push_back(part == None ? 0 : 1);
  }
  return keep;
}

inline Index howMany(const medial::PolarBalls& balls, medial::Side side)
{
  return static_cast<Index>(std::count(balls.sides.begin(), balls.sides.end(), side));
}

/// Keeps the inner balls on one side of a plane.
inline std::vector<char> keepBelow(const medial::PolarBalls& all, double x)
{
  std::vector<char> keep;
  for (const medial::Ball& ball : all.balls)
  {
    keep.push_back(ball.center.x() < x ? 1 : 0);
  }
  return keep;
}

/// The area of a triangle of the axis, given as a cell.
inline double areaOf(const medial::MedialAxis& axis, Index cell)
{
  const medial::Triangle& t = axis.cells.triangles[cell - axis.cells.firstTriangle()];
  const Point& a = axis.points[t[0]];
  return 0.5 * (axis.points[t[1]] - a).cross(axis.points[t[2]] - a).norm();
}

class Pipeline
{
public:
  explicit Pipeline(const shapes::Shape& aShape)
    : shape(aShape)
    , diagonal(validators::diagonal(aShape.samples))
  {
  }

  const shapes::Shape shape;
  const double diagonal; ///< of the samples' bounding box

  const medial::PolarBallsAndSamples& ballsAndSamples()
  {
    return once(
      this->theBalls, [this] { return medial::polarBallsAndSamples(this->shape.samples); });
  }
  const medial::PolarBalls& balls() { return this->ballsAndSamples().balls; }
  const medial::PowerShape& powerShape()
  {
    return once(this->thePowerShape, [this] { return medial::powerShape(this->balls()); });
  }
  const medial::SingularPoints& sites()
  {
    return once(
      this->theSites, [this] { return medial::singularPoints(this->balls(), this->powerShape()); });
  }
  const medial::MedialAxis& axis()
  {
    return once(this->theAxis, [this] { return medial::medialAxis(this->balls()); });
  }
  const medial::MedialParts& parts()
  {
    return once(this->theParts, [this] { return medial::decompose(this->axis()); });
  }
  const medial::Pruned& pruned()
  {
    return once(
      this->thePruned, [this] { return medial::prune(this->axis(), standardSchedule()); });
  }
  const medial::Crust& crust()
  {
    return once(this->theCrust, [this] { return medial::powerCrust(this->balls()); });
  }
  std::vector<char> keptAfterPruning()
  {
    return keptBalls(this->pruned().axis, this->pruned().parts);
  }
  const medial::Crust& crustAfterPruning()
  {
    return once(this->theCrustAfterPruning,
      [this] { return medial::powerCrust(this->balls(), this->keptAfterPruning()); });
  }

private:
  template <typename Value, typename Make>
  static const Value& once(std::optional<Value>& value, const Make& make)
  {
    if (!value)
    {
      value = make();
    }
    return *value;
  }

  std::optional<medial::PolarBallsAndSamples> theBalls;
  std::optional<medial::PowerShape> thePowerShape;
  std::optional<medial::SingularPoints> theSites;
  std::optional<medial::MedialAxis> theAxis;
  std::optional<medial::MedialParts> theParts;
  std::optional<medial::Pruned> thePruned;
  std::optional<medial::Crust> theCrust, theCrustAfterPruning;
};

/// One for each of shapes::all().
inline std::deque<Pipeline>& all()
{
  static std::deque<Pipeline> pipelines(shapes::all().begin(), shapes::all().end());
  return pipelines;
}

inline Pipeline& of(const char* name)
{
  for (Pipeline& pipeline : all())
  {
    if (pipeline.shape.name == name)
    {
      return pipeline;
    }
  }
  throw std::invalid_argument("no shape is called " + std::string(name));
}

/// Runs the test for every shape, and says for which it fails.
inline void forEachShape(const std::function<void(Pipeline&)>& test)
{
  for (Pipeline& pipeline : all())
  {
    SCOPED_TRACE(testing::Message() << pipeline.shape.name << ", seed " << pipeline.shape.seed);
    test(pipeline);
  }
}

/// The contents of a result, to compare bit by bit.
class Bytes
{
public:
  template <typename Item>
  Bytes& add(const std::vector<Item>& items)
  {
    // Without padding: numbers and fixed arrays of them.
    const auto* first = reinterpret_cast<const char*>(items.data());
    this->text += std::to_string(items.size()) + ":";
    this->text.append(first, items.size() * sizeof(Item));
    return *this;
  }
  Bytes& add(const IndexLists& lists) { return this->add(lists.offsets).add(lists.items); }
  template <typename Number>
  std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>, Bytes&> add(
    Number number)
  {
    return this->add(std::vector<double>{ static_cast<double>(number) });
  }
  Bytes& add(const medial::Betti& betti)
  {
    return this->add(std::vector<Index>(betti.begin(), betti.end()));
  }
  Bytes& add(const Point& point) { return this->add(std::vector<Point>{ point }); }

  std::string text;
};

inline std::string bytesOf(const medial::PolarBalls& b)
{
  Bytes bytes;
  bytes.add(b.samples).add(b.innerBall).add(b.outerBall);
  bytes.add(b.balls).add(b.sides).add(b.touchesGuard).add(b.volumes).add(b.poleVolumes);
  bytes.add(b.ballSamples);
  return bytes.add(b.spacing).add(b.triangulation.cells).text;
}

inline std::string bytesOf(const medial::PolarBallsAndSamples& made)
{
  const medial::SampleDescription& samples = made.samples;
  return bytesOf(made.balls) + Bytes().add(samples.duplicateOf).add(samples.quality).text;
}

inline std::string bytesOf(const medial::SingularPoints& s)
{
  return Bytes().add(s.positions).add(s.samples).add(s.balls).text;
}

inline std::string bytesOf(const medial::MedialAxis& a)
{
  Bytes bytes;
  bytes.add(a.points).add(a.radii).add(a.ballOfPoint).add(a.erosion).add(a.cellErosion);
  bytes.add(a.cells.vertices).add(a.cells.edges).add(a.cells.triangles);
  bytes.add(a.polygonOfCell)
    .add(a.samplesOfCell)
    .add(a.siteViews)
    .add(a.ballOwner)
    .add(a.ballVolumes);
  bytes.add(a.poleVolumes)
    .add(a.powerShapeBetti)
    .add(a.betti)
    .add(a.certificate)
    .add(a.fallback)
    .add(a.kappa)
    .add(a.filledGaps);
  return bytes.text;
}

inline std::string bytesOf(const medial::MedialParts& p)
{
  Bytes bytes;
  bytes.add(p.partOfCell);
  for (const medial::MedialPart& part : p.parts)
  {
    bytes.add(part.dimension).add(part.level).add(part.volume).add(part.minimumRadius);
    bytes.add(part.contacts).add(part.neighbors).add(part.neckRatio).add(part.onLoop);
    bytes.add(part.principalLengths).add(part.lower).add(part.upper).add(part.centroid);
  }
  for (const std::vector<double>& values : p.values)
  {
    bytes.add(values);
  }
  for (const medial::ContactCurve& curve : p.contacts)
  {
    bytes.add(curve.points).add(curve.parts);
  }
  return bytes.text;
}

inline std::string bytesOf(const medial::Pruned& p)
{
  Bytes bytes;
  bytes.text = bytesOf(p.axis) + bytesOf(p.parts);
  bytes.add(p.keepReason)
    .add(p.fates)
    .add(p.inputCell)
    .add(p.removedInIteration)
    .add(p.removedPart);
  for (const medial::PruneRow& row : p.history)
  {
    bytes.add(row.byHand).add(row.measure).add(row.threshold).add(row.passes);
    bytes.add(row.partsBefore).add(row.partsAfter).add(row.candidates).add(row.removed);
    bytes.add(row.refused).add(row.refusedByTopology).add(row.refusedIsolated);
    bytes.add(row.refusedProtected).add(row.topologyChanges);
    bytes.add(row.betti).add(row.volumeRemoved);
  }
  return bytes.text;
}

/// The triangles of a crust as the validators take faces.
inline medial::IndexLists facesOf(const medial::Crust& crust)
{
  medial::IndexLists faces;
  std::for_each(crust.triangles.begin(), crust.triangles.end(),
    [&faces](const medial::Triangle& triangle) { faces.append(triangle); });
  return faces;
}

inline std::string bytesOf(const medial::Crust& c)
{
  Bytes bytes;
  bytes.add(c.points).add(c.sampleOfPoint).add(c.triangles).add(c.innerBall).add(c.outerBall);
  bytes.add(c.betti).add(c.closed).add(c.manifold).add(c.volume);
  bytes.add(c.putBackBalls).add(c.insertedBalls).add(c.refusedBalls);
  return bytes.add(c.rounds).add(c.maximumClearance).text;
}

inline std::vector<double> times(std::vector<double> values, double factor)
{
  for (double& value : values)
  {
    value *= factor;
  }
  return values;
}

/// The same in another unit; exact where the factor is a power of two.
inline medial::PolarBalls inUnits(medial::PolarBalls b, double factor)
{
  b.samples = shapes::scaled(b.samples, factor);
  b.spacing *= factor;
  for (medial::Ball& ball : b.balls)
  {
    ball = { ball.center * factor, ball.radius * factor };
  }
  b.volumes = times(b.volumes, factor * factor * factor);
  b.poleVolumes = times(b.poleVolumes, factor * factor * factor);
  return b;
}

inline medial::MedialAxis inUnits(medial::MedialAxis a, double factor)
{
  a.points = shapes::scaled(a.points, factor);
  a.radii = times(a.radii, factor);
  a.ballVolumes = times(a.ballVolumes, factor * factor * factor);
  a.poleVolumes = times(a.poleVolumes, factor * factor * factor);
  a.erosion = times(a.erosion, factor);
  a.sampleDiagonal *= factor;
  a.sampleSpacing *= factor;
  a.cellErosion = times(a.cellErosion, factor);
  for (medial::SiteView& view : a.siteViews)
  {
    view.lambda *= factor;
  }
  return a;
}

inline medial::Crust inUnits(medial::Crust c, double factor)
{
  c.points = shapes::scaled(c.points, factor);
  c.volume *= factor * factor * factor;
  return c;
}

/// The axis as polygons, whatever diagonals they were cut along.
inline validators::Polygons polygonsOf(const medial::MedialAxis& axis)
{
  validators::Polygons result{ axis.points, {} };
  for (const Index vertex : axis.cells.vertices)
  {
    result.polygons.push_back({ vertex });
  }
  for (const medial::Edge& edge : axis.cells.edges)
  {
    result.polygons.emplace_back(edge.begin(), edge.end());
  }
  std::map<Index, std::vector<Index>> polygons;
  for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
  {
    std::vector<Index>& polygon = polygons[axis.polygonOfCell[axis.cells.firstTriangle() + t]];
    const medial::Triangle& triangle = axis.cells.triangles[t];
    polygon.insert(polygon.end(), triangle.begin(), triangle.end());
  }
  for (const auto& [number, corners] : polygons)
  {
    result.polygons.push_back(corners);
  }
  return result;
}

/// The same with other coordinates.
inline validators::Polygons placedAt(validators::Polygons polygons, std::vector<Point> points)
{
  polygons.points = std::move(points);
  return polygons;
}

inline medial::Betti independentBetti(const medial::MedialAxis& axis)
{
  return validators::bettiNumbers(complexes::complexOf(axis.cells));
}
}

#endif
