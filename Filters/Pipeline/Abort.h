// SPDX-License-Identifier: BSD-3-Clause
#ifndef Abort_h
#define Abort_h

#include "Base/Errors.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkVersion.h"

/// How a filter is stopped. VTK has one flag for it, AbortExecute, which its pipeline takes back when a
/// run begins, and which no run after the stopped one follows, since the empty outputs count as up to
/// date. Here, what is asked for before a run holds for this run, and a stopped run is made again at the
/// next update. For that a filter overrides three methods, which medialAbortMacro defines.
namespace medial
{
/// Was a stop asked for outside a run, and not yet followed?
inline vtkInformationIntegerKey* abortWanted()
{
  static auto* const key = vtkInformationIntegerKey::MakeKey("ABORT_WANTED", "MedialAxis");
  return key;
}

/// Is the run that begins to stop at once?
inline vtkInformationIntegerKey* abortAtStart()
{
  static auto* const key = vtkInformationIntegerKey::MakeKey("ABORT_AT_START", "MedialAxis");
  return key;
}

/// Was the last run stopped?
inline vtkInformationIntegerKey* wasStopped()
{
  static auto* const key = vtkInformationIntegerKey::MakeKey("WAS_STOPPED", "MedialAxis");
  return key;
}

/// What a filter's SetAbortExecute was called with.
inline void noteAbort(vtkAlgorithm* filter, vtkTypeBool stop)
{
  filter->GetInformation()->Set(abortWanted(), stop);
}

/// The tag of the observer that forgetAtEnd adds.
inline vtkInformationIntegerKey* forgetter()
{
  static auto* const key = vtkInformationIntegerKey::MakeKey("FORGETTER", "MedialAxis");
  return key;
}

/// Whatever stop was asked for until the run ends is followed by then. VTK since 9.2 reports progress once
/// more after a stopped run, and who asks in such a report does not mean the next run. Writers report
/// their end twice, the first time before that progress: so the observer stays until the next run.
inline void forgetAtEnd(vtkAlgorithm* filter)
{
  vtkInformation* information = filter->GetInformation();
  filter->RemoveObserver(static_cast<unsigned long>(information->Get(forgetter())));
  vtkNew<vtkCallbackCommand> forget;
  forget->SetCallback([](vtkObject* sender, unsigned long, void*, void*) {
    static_cast<vtkAlgorithm*>(sender)->GetInformation()->Set(abortWanted(), 0);
  });
  information->Set(
    forgetter(), static_cast<int>(filter->AddObserver(vtkCommand::EndEvent, forget)));
}

/// Before VTK takes the flag back, which it does after this request.
inline void keepAbort(vtkAlgorithm* filter, vtkInformation* request)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_NOT_GENERATED()))
  {
    vtkInformation* information = filter->GetInformation();
    information->Set(abortAtStart(), information->Get(abortWanted()));
    information->Set(wasStopped(), 0);
    filter->SetAbortExecute(0); // since VTK 9.2 nobody else does it
    forgetAtEnd(filter);
  }
}

/// At the start of each update: a stopped run has left nothing that could be up to date.
inline void repeatStopped(vtkAlgorithm* filter)
{
  if (filter->GetInformation()->Get(wasStopped()))
  {
    filter->GetInformation()->Set(wasStopped(), 0);
    filter->Modified();
  }
}

inline bool stopRequested(vtkAlgorithm* filter)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220101)
  return filter->CheckAbort();
#else
  return filter->GetAbortExecute() != 0;
#endif
}

/// Has a filter somewhere before this one been stopped, so that there is no input to work on?
inline bool inputStopped(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* before = filter->GetInputAlgorithm(port, i);
      if (before->GetAbortExecute() || before->GetInformation()->Get(wasStopped()) ||
        inputStopped(before))
      {
        return true;
      }
    }
  }
  return false;
}

/// At the start of the work on the whole input, or on a block of it.
/// @throw Aborted  it is to stop at once
inline void requireNotStopped(vtkAlgorithm* filter)
{
  if (filter->GetInformation()->Get(abortAtStart()))
  {
    filter->SetAbortExecute(1); // shows that it was stopped
  }
  if (stopRequested(filter) || inputStopped(filter))
  {
    throw Aborted();
  }
}

/// At the end of work that was stopped.
inline void noteStopped(vtkAlgorithm* filter)
{
  filter->GetInformation()->Set(wasStopped(), 1);
}
}

/// Defines the three methods of a filter, beside vtkStandardNewMacro.
#define medialAbortMacro(thisClass)                                                                \
  void thisClass::SetAbortExecute(vtkTypeBool stop)                                                \
  {                                                                                                \
    medial::noteAbort(this, stop);                                                                 \
    this->Superclass::SetAbortExecute(stop);                                                       \
  }                                                                                                \
  int thisClass::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,      \
    vtkInformationVector* outputs, int port, vtkMTimeType* mtime)                                  \
  {                                                                                                \
    medial::repeatStopped(this);                                                                   \
    return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, mtime);          \
  }                                                                                                \
  vtkTypeBool thisClass::ProcessRequest(                                                           \
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)         \
  {                                                                                                \
    medial::keepAbort(this, request);                                                              \
    return this->Superclass::ProcessRequest(request, inputs, outputs);                             \
  }                                                                                                \
  static_assert(true, "")

#endif
