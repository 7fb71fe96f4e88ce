// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCollectParts
 * @brief   the parts of all objects of a collection: one table, and numbers that occur only once
 *
 * After the medial axis pipeline, where each block of a collection is an object of its own, with a
 * table of its own and parts numbered from 0.
 *
 * Input 0: vtkCompositeDataSet, the tables: output 1 of vtkMedialPartDecomposition or 2 of
 * vtkSimplifyShape.
 *
 * Input 1: vtkCompositeDataSet, optional, of the same blocks: any output with the array `PartId` that
 * goes with these tables, such as the parts, the topology graph, or the surface of vtkSimplifyShape.
 *
 * Output 0: vtkTable, one after another the rows of all tables, with the columns of these and
 *  - `ObjectId` (vtkIdType, the first): number of the block in the collection, from 0, empty ones too.
 *
 * Output 1: input 1; where it isn't connected, none of its blocks.
 *
 * With UniquePartIds the numbers `PartId` of both outputs go on from block to block. They are to look
 * at, select and compare by: the other filters take their input with numbers from 0.
 *
 * Under MPI the numbers and the table are the same for any number of ranks; rank 0 has the table.
 *
 * An error (a block that isn't a table, tables with different columns) leaves the outputs empty and
 * sets the error code.
 *
 * @sa vtkMedialPartDecomposition vtkShareOutObjects vtkSimplifyShape
 */

#ifndef vtkCollectParts_h
#define vtkCollectParts_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersMedialModule.h" // for export macro

class VTKFILTERSMEDIAL_EXPORT vtkCollectParts : public vtkDataObjectAlgorithm
{
public:
  static vtkCollectParts* New();
  vtkTypeMacro(vtkCollectParts, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Let `PartId` go on from block to block, so that each number occurs once. Default off.
   */
  vtkSetMacro(UniquePartIds, bool);
  vtkGetMacro(UniquePartIds, bool);
  vtkBooleanMacro(UniquePartIds, bool);
  ///@}

  /**
   * Connects input 1.
   */
  void SetPartsConnection(vtkAlgorithmOutput* parts) { this->SetInputConnection(1, parts); }

protected:
  vtkCollectParts();
  ~vtkCollectParts() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkCollectParts(const vtkCollectParts&) = delete;
  void operator=(const vtkCollectParts&) = delete;

  bool UniquePartIds = false;
};

#endif
