// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMedialMeshReader
 * @brief   a medial mesh from a .ma file, the form in which programs exchange medial axes
 *
 * Output: vtkPolyData. Lines are the edges of the file that are no sides of its triangles, since most
 * programs list those too; the sides are there as well where the file gives them a type other than 0.
 * Vertices are the points in no edge and no triangle.
 *
 * Points
 *  - `Radius` (double): of the ball centred there.
 *  - `Type` (int): only where the file has types; of MATTopo the kind of sphere.
 *
 * Cells
 *  - `Type` (int): only where edges have types; of MATTopo 0 none, 1 inner, 2 outer feature. -1 for vertices and
 *    triangles.
 *
 * A file begins with a line `nv ne nf`; then come `v x y z r`, `e i j` and `f i j k`, where points are counted
 * from 0. Also read are blank lines and what follows a #; lines in another order; types, `v x y z r t` and `e i j t`; points
 * counted from 1 (Coverage Axis), where the number of points occurs as an index and 0 never does; and `.ma_dup` files of
 * MATTopo, with four numbers in the first line. Of these, what is marked as deleted and the tetrahedra are left out.
 * Edges and triangles that come again are taken once. Warning events tell of tetrahedra and of what came again.
 *
 * An error (the file can't be read, or a line is wrong: the message has its number) leaves the output empty
 * and sets the error code. Under MPI the piece 0 holds everything.
 *
 * The other filters can't go on from such a mesh: it has no samples and no outer balls.
 *
 * @sa vtkMedialMeshWriter vtkMedialAxis
 */

#ifndef vtkMedialMeshReader_h
#define vtkMedialMeshReader_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSMEDIAL_EXPORT vtkMedialMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMedialMeshReader* New();
  vtkTypeMacro(vtkMedialMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Stops the run under way, or the next one where there is none. The output of a stopped run is empty;
   * the update after it makes it.
   */
  void SetAbortExecute(vtkTypeBool stop) override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* mtime) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  ///@{
  /**
   * The file to be read.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkMedialMeshReader();
  ~vtkMedialMeshReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMedialMeshReader(const vtkMedialMeshReader&) = delete;
  void operator=(const vtkMedialMeshReader&) = delete;

  char* FileName = nullptr;
};

#endif
