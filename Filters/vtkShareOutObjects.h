// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShareOutObjects
 * @brief   gives each rank of an MPI program its part of a collection of objects
 *
 * Before the medial axis pipeline, where many objects wait and many ranks can work. Each object is
 * a problem of its own; a rank computes its objects as a whole. Without this filter the first rank
 * computes everything.
 *
 * Input: vtkCompositeDataSet, for example vtkMultiBlockDataSet or vtkPartitionedDataSetCollection,
 * with an object in each block. Each rank reads all of it.
 *
 * Output: the same with the blocks of this rank only; the others are empty. The objects with most
 * points are given first, each to the rank with the fewest points so far, so that every rank knows
 * who has what. Without MPI all blocks are passed.
 *
 * Field data of each block
 *  - `ObjectId` (vtkIdType, 1 value): its number in the collection, from 0, empty blocks too. It
 *    tells the filters after this one that the block is a whole object, and is passed on by them.
 *
 * @sa vtkPolarBalls vtkSimplifyShape
 */

#ifndef vtkShareOutObjects_h
#define vtkShareOutObjects_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"

class VTKFILTERSMEDIAL_EXPORT vtkShareOutObjects : public vtkPassInputTypeAlgorithm
{
public:
  static vtkShareOutObjects* New();
  vtkTypeMacro(vtkShareOutObjects, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkShareOutObjects() = default;
  ~vtkShareOutObjects() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkShareOutObjects(const vtkShareOutObjects&) = delete;
  void operator=(const vtkShareOutObjects&) = delete;
};

#endif
