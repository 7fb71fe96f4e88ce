// SPDX-License-Identifier: BSD-3-Clause
#ifndef Objects_h
#define Objects_h

#include "vtkCompositeDataIterator.h"
#include "vtkSmartPointer.h"

class vtkCompositeDataSet;
class vtkDataObject;
class vtkPolyData;
class vtkUnstructuredGrid;

/// Collections of objects. Each is a problem of its own.
namespace medial
{
/// The first block of a collection. Empty ones (nullptr) count too: each object has the same number on
/// every rank.
vtkSmartPointer<vtkCompositeDataIterator> firstBlock(vtkCompositeDataSet* data);

/// Copies the blocks of `input` that are this rank's, each with its number, and the structure of all.
/// Every rank finds the same: the object with most points goes to the rank with fewest so far.
void shareOut(vtkCompositeDataSet* input, int rank, int rankCount, vtkCompositeDataSet* output);

/// Is it a whole object that shareOut has given to this rank?
bool isSharedOut(vtkDataObject* data);

/// The axis made from these balls: `axes` itself, unchecked, or the block that was made from them.
/// @return  nullptr where `axes` is
/// @throw InvalidInput  it has no such block
vtkPolyData* axisOf(vtkUnstructuredGrid* balls, vtkDataObject* axes);

/// The surface made from these balls: `surfaces` itself, unchecked, or the block that was made from them.
/// @throw InvalidInput  it has no such block
vtkPolyData* surfaceOf(vtkUnstructuredGrid* balls, vtkDataObject* surfaces);
}

#endif
