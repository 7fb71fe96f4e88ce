// SPDX-License-Identifier: BSD-3-Clause
#include "Inflation.h"

#include <zlib.h>

#include <fstream>
#include <vector>

namespace
{
/// Inflates what is in `stream`; counts the bytes. Ends where the input ends, or is damaged.
/// @return  can there be more?
bool inflateAll(z_stream& stream, std::vector<Bytef>& room, double& found)
{
  while (stream.avail_in > 0)
  {
    stream.next_out = room.data();
    stream.avail_out = static_cast<uInt>(room.size());
    const int state = inflate(&stream, Z_NO_FLUSH);
    found += static_cast<double>(room.size() - stream.avail_out);
    // A gzip file may consist of several, one after the other.
    if (state == Z_STREAM_END && stream.avail_in > 0 && inflateReset(&stream) == Z_OK)
    {
      continue;
    }
    if (state != Z_OK && state != Z_BUF_ERROR)
    {
      return state == Z_STREAM_END && inflateReset(&stream) == Z_OK;
    }
  }
  return true;
}
}

bool inflatesTo(const std::string& file, std::streamoff begin, double bytes)
{
  constexpr std::size_t chunk = 1 << 16;
  constexpr int anyHeader = 15 + 32; // gzip's or zlib's, and the largest window
  std::ifstream in(file, std::ios::binary);
  in.seekg(begin);
  z_stream stream = {};
  if (inflateInit2(&stream, anyHeader) != Z_OK)
  {
    return false;
  }
  std::vector<char> packed(chunk);
  std::vector<Bytef> room(4 * chunk);
  double found = 0;
  bool more = true;
  while (more && found < bytes && in.good())
  {
    in.read(packed.data(), chunk);
    stream.next_in = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_in = static_cast<uInt>(in.gcount());
    more = inflateAll(stream, room, found);
  }
  inflateEnd(&stream);
  return found >= bytes;
}
