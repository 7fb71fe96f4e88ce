// SPDX-License-Identifier: BSD-3-Clause
#ifndef Verdict_h
#define Verdict_h

#include <string>
#include <vector>

class vtkSimplifyShape;

/// What contradicts the word "certified", a sentence each; empty: nothing does. The result is certified if
/// power shape, axis, pruned axis and surface have the same Betti numbers, each computed from its own
/// cells (the pruned axis may differ where topology is not kept), and the surface is a closed manifold.
///
/// Reads the outputs of the filter's stages after an update.
std::vector<std::string> contradictions(vtkSimplifyShape* simplify);

#endif
