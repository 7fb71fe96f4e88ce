// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/FileContent.h"

#include "Base/Errors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <vector>

namespace medial
{
std::string contentOf(const std::string& file, const Execution& execution)
{
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string content;
  std::vector<char> piece(std::size_t(1) << 20);
  while (
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0)
  {
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
    execution.poll();
  }
  if (!stream.is_open() || stream.bad())
  {
    throw InvalidInput(
      file, ": can't be read: ", std::strerror(errno), "; check the name and the permissions");
  }
  return content;
}

void writeContent(const std::string& file, const std::string& content)
{
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  const bool isOpen = stream.is_open();
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream)
  {
    const std::string reason = std::strerror(errno);
    std::error_code ignored;
    if (isOpen && std::filesystem::is_regular_file(file, ignored)) // no device
    {
      std::filesystem::remove(file, ignored);
    }
    throw InvalidInput(file, ": can't be written: ", reason, "; choose another place");
  }
}
}
