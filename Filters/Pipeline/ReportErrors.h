// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReportErrors_h
#define ReportErrors_h

#include "Base/Errors.h"
#include "Base/Execution.h"
#include "Collections/Objects.h"
#include "Pipeline/Abort.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerVectorKey.h"
#include "vtkInformationStringKey.h"
#include "vtkInformationStringVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkSMPTools.h"
#include "vtkSetGet.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <string>

/// What a filter has to tell the pipeline around its one call of the core: pieces, progress, abort,
/// threads, errors.
namespace medial
{
/// What is asked for at the output that the request comes from.
inline vtkInformation* askedOutput(vtkInformation* request, vtkInformationVector* outputs)
{
  const int port = request->Has(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT())
    ? std::max(0, request->Get(vtkDemandDrivenPipeline::FROM_OUTPUT_PORT()))
    : 0;
  return outputs->GetInformationObject(port);
}

/// Is the piece asked for the first, which holds everything? The others are empty.
inline bool isFirstPiece(vtkInformation* request, vtkInformationVector* outputs)
{
  vtkInformation* output = askedOutput(request, outputs);
  return !output || !output->Has(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) ||
    output->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) == 0;
}

/// The piece, of how many, with how many ghost levels, that was asked for at an output.
inline vtkInformationIntegerVectorKey* askedPiece()
{
  static auto* const key = vtkInformationIntegerVectorKey::MakeKey("ASKED_PIECE", "MedialAxis", 3);
  return key;
}

/// Notes at all outputs the piece that is asked for at one, where the input is a collection: they are
/// made together.
inline void notePiece(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* asked = askedOutput(request, outputs);
  if (!asked || !vtkCompositeDataSet::GetData(inputs[0]))
  {
    return;
  }
  const int piece[] = { asked->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()),
    asked->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()) };
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Set(askedPiece(), piece, 3);
  }
}

/// Puts back what was asked for. While vtkCompositeDataPipeline works through the blocks it asks for
/// the first piece of one instead, and leaves it so: it would take the blocks for another piece's and
/// make them again at every update.
inline void restorePiece(vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port);
    if (output->Has(askedPiece()))
    {
      output->Set(Pipeline::UPDATE_PIECE_NUMBER(), output->Get(askedPiece(), 0));
      output->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), output->Get(askedPiece(), 1));
      output->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), output->Get(askedPiece(), 2));
    }
  }
}

/// Asks every input for all of it as one piece, and for all voxels of an image: no stage can work on a part of
/// the object. For another piece than the first, which is empty, the input is not needed: it is asked for the same piece.
inline int requestWholeInputs(vtkAlgorithm* filter, vtkInformation* request,
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  notePiece(request, inputs, outputs);
  if (!isFirstPiece(request, outputs))
  {
    return 1;
  }
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputs[port]->GetInformationObject(i);
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
      if (vtkImageData::GetData(input) && input->Has(Pipeline::WHOLE_EXTENT()))
      {
        input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
      }
    }
  }
  return 1;
}

inline void emptyOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

/// vtkSMPTools::For with the first exception of any thread thrown again on the calling thread.
inline void parallelFor(Index count, const Execution::Range& body)
{
  std::mutex mutex;
  std::exception_ptr error;
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    try
    {
      body(static_cast<Index>(begin), static_cast<Index>(end));
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      error = std::current_exception();
    }
  });
  if (error)
  {
    std::rethrow_exception(error);
  }
}

/// The core's view of `filter`: it reports progress to it and lets it stop the work.
inline Execution execution(vtkAlgorithm* filter)
{
  Execution result;
  result.progress = [filter](double done) {
    filter->UpdateProgress(done);
    return !stopRequested(filter);
  };
  result.parallelFor = parallelFor;
  return result;
}

/// vtkAlgorithm::SetErrorCode, which only a filter's own methods may call otherwise.
inline void setErrorCode(vtkAlgorithm* filter, unsigned long code)
{
  struct Access : vtkAlgorithm
  {
    using vtkAlgorithm::SetErrorCode;
  };
  (filter->*&Access::SetErrorCode)(code);
}

/// The key under which a filter keeps its error message.
inline vtkInformationStringKey* errorMessageKey()
{
  static auto* const key = vtkInformationStringKey::MakeKey("ERROR_MESSAGE", "MedialAxis");
  return key;
}

/// The message of a filter's last error, as the core worded it; "" if there was no error. VTK's own
/// error event has the message too, but within a text with file, line and object.
inline const char* errorMessage(vtkAlgorithm* filter)
{
  const char* message = filter->GetInformation()->Get(errorMessageKey());
  return message ? message : "";
}

/// Keeps the message of an error, or "" for none. This is no change of the filter: its MTime stays.
inline void setErrorMessage(vtkAlgorithm* filter, const std::string& message)
{
  filter->GetInformation()->Set(errorMessageKey(), message);
}

/// VTK compares the type of an input with what the filter takes, but not that of the blocks of a collection, which come one
/// after another.
/// @throw InvalidInput  an input is of no type that the filter takes
inline void requireInputTypes(vtkAlgorithm* filter, vtkInformationVector** inputs)
{
  vtkInformationStringVectorKey* const types = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* taken = filter->GetInputPortInformation(port);
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* input = vtkDataObject::GetData(inputs[port], i);
      bool isTaken = !input;
      std::string names;
      for (int k = 0; k < taken->Length(types) && !isTaken; ++k)
      {
        isTaken = input->IsA(types->Get(taken, k));
        names += (k > 0 ? " or " : "") + std::string(types->Get(taken, k));
      }
      if (!isTaken)
      {
        throw InvalidInput("input ", port, ", or a block of it, is a ", input->GetClassName(),
          ", but has to be a ", names, ": take the output of the filter before this one");
      }
    }
  }
}

/// Runs body(execution) on every rank and turns what it throws into a VTK error and empty outputs; the
/// value is that of RequestData. Work that was stopped, or whose input was, has empty outputs too, but is
/// no error.
template <typename Body>
int reportErrorsOfAllRanks(vtkAlgorithm* filter, vtkInformationVector* outputs, const Body& body)
{
  setErrorCode(filter, vtkErrorCode::NoError);
  setErrorMessage(filter, "");
  emptyOutputs(outputs);
  try
  {
    requireNotStopped(filter);
    body(execution(filter));
    return 1;
  }
  catch (const Aborted&)
  {
    emptyOutputs(outputs);
    noteStopped(filter);
    return 1;
  }
  catch (const std::exception& error)
  {
    emptyOutputs(outputs);
    setErrorCode(filter, vtkErrorCode::UserError);
    setErrorMessage(filter, error.what());
    vtkErrorWithObjectMacro(filter, << error.what());
    return 0;
  }
}

/// The same on the rank that computes this object; the others have empty outputs.
template <typename Body>
int reportErrors(vtkAlgorithm* filter, vtkInformation* request, vtkInformationVector** inputs,
  vtkInformationVector* outputs, const Body& body)
{
  const int result = reportErrorsOfAllRanks(filter, outputs, [&](const Execution& execution) {
    const bool isMine =
      isFirstPiece(request, outputs) || isSharedOut(vtkDataObject::GetData(inputs[0]));
    if (isMine)
    {
      requireInputTypes(filter, inputs);
      body(execution);
    }
  });
  restorePiece(outputs);
  return result;
}
}

#endif
