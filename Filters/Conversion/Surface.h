// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Surface_h
#define Conversion_Surface_h

#include "Balls/ProvenSamples.h"
#include "Base/SurfaceTree.h"
#include "Samples/WrappedSurface.h"

#include <optional>

class vtkFieldData;
class vtkPointSet;
class vtkPolyData;

namespace medial
{
/// The closed surface that the polygons of a data set are, or can be mended to.
/// @param wrap          if it is given: the surface around the polygons where they are none
/// @throw InvalidInput  a coordinate is not finite; see closedSurface() and wrappedSurface()
ClosedSurface readSurface(
  vtkPointSet* input, const std::optional<WrapOptions>& wrap = {}, const Execution& execution = {});

/// The surface of a solid, and its Betti numbers, as balls need them.
struct Solid
{
  SurfaceTree tree;
  Betti betti;
};

/// @throw InvalidInput  see readSurface()
Solid readSolid(vtkPolyData* input, const Execution& execution = {});

/// Writes samples and surface, as vtkBoundarySamples.h describes them.
/// @param input  its field data is passed on to both outputs
void write(const ProvenSamples& made, const ClosedSurface& surface, vtkPointSet* input,
  vtkPolyData* samples, vtkPolyData* closed);
}

#endif
