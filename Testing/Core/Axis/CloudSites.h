// SPDX-License-Identifier: BSD-3-Clause
#ifndef CloudSites_h
#define CloudSites_h

#include "Axis/SiteTriangulation.h"
#include "Base/Triangulations.h"
#include "Shapes.h"

/// The Delaunay triangulation of random points in a cube as one of sites: mesh, edges and number alone.
inline medial::SiteTriangulation cloudSites(int count, unsigned seed)
{
  medial::SiteTriangulation sites;
  const std::vector<medial::Point> points = shapes::cloud(count, seed);
  sites.mesh = medial::delaunay(points);
  sites.siteCount = medial::count(points);
  sites.edges = medial::edgeNumbers(sites.mesh.cells, sites.siteCount);
  return sites;
}

#endif
