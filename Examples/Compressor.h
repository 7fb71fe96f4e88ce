// SPDX-License-Identifier: BSD-3-Clause
#ifndef Compressor_h
#define Compressor_h

#include <vtkZLibDataCompressor.h>

#include <string>
#include <unordered_map>

/// VTK's compressor, which remembers what became of each block of bytes: arrays that are in several files are
/// compressed once. It has no vtkTypeMacro, so that files name VTK's own class, which reads them.
class Compressor : public vtkZLibDataCompressor
{
public:
  static Compressor* New();

  /// Compresses from now on as before, but remembers no more blocks.
  void learnNoMore() { this->Learns = false; }

protected:
  Compressor();

  std::size_t CompressBuffer(const unsigned char* bytes, std::size_t size,
    unsigned char* compressed, std::size_t space) override;

private:
  bool Learns = true;
  std::unordered_map<std::string, std::string> Known; ///< what became of these bytes
};

#endif
