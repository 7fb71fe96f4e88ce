// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBackgroundUpdate
 * @brief   updates a filter on a thread of its own
 *
 * For callers that have to go on meanwhile, such as Python, which runs no other thread and notices no
 * Ctrl-C while it waits for a method of C++. `medialaxis.simplify` uses it. The caller asks from time to
 * time whether the update is done.
 *
 * Until then it must leave the filter and its inputs alone. Observers of the filter are called on the
 * other thread: those written in Python would crash there, so there must be none. Errors and warnings of
 * the filter are not printed; the filter keeps them.
 *
 * @sa vtkSimplifyShape
 */

#ifndef vtkBackgroundUpdate_h
#define vtkBackgroundUpdate_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr

class vtkAlgorithm;

class VTKFILTERSMEDIAL_EXPORT vtkBackgroundUpdate : public vtkObject
{
public:
  static vtkBackgroundUpdate* New();
  vtkTypeMacro(vtkBackgroundUpdate, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Begins an update of the filter. An error if one is under way.
   */
  void Start(vtkAlgorithm* filter);

  /**
   * Is the update under way? Once it isn't, the outputs may be used.
   */
  bool IsRunning();

  /**
   * How much of the update is done, 0 ... 1.
   */
  double GetProgress();

  /**
   * Asks the filter to stop, as SetAbortExecute does. The update goes on until the filter notices, within
   * a second; the outputs are empty then.
   */
  void Stop();

protected:
  vtkBackgroundUpdate();
  ~vtkBackgroundUpdate() override; // stops and waits

private:
  vtkBackgroundUpdate(const vtkBackgroundUpdate&) = delete;
  void operator=(const vtkBackgroundUpdate&) = delete;

  struct vtkRun;
  std::unique_ptr<vtkRun> Run;
};

#endif
