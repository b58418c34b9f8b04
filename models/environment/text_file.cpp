// SPDX-License-Identifier: MIT
#include "models/environment/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

#include "models/environment/input_error.hpp"

namespace cigsim {

std::string lower_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

std::string read_whole_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string(), 0, "is a folder; name a scene file inside it");
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  const std::unique_ptr<std::FILE, Close> input(std::fopen(file.c_str(), "rb"));
  if (!input && errno == ENOENT)
    throw InputError(file.string(), 0, "no such file; check the name and the folder");
  if (!input)
    throw InputError(
        file.string(), 0,
        std::string("cannot be opened (") + std::strerror(errno) + "); check its permissions");
  std::string bytes;
  const auto size = std::filesystem::file_size(file, error);
  try {
    if (!error) bytes.reserve(size);
    char block[1 << 16];
    std::size_t got = 0;
    while ((got = std::fread(block, 1, sizeof block, input.get())) > 0) bytes.append(block, got);
  } catch (const std::bad_alloc&) {
    throw InputError(file.string(), 0, "does not fit in memory; split the scene");
  }
  if (std::ferror(input.get()))
    throw InputError(file.string(), 0,
                     std::string("cannot be read (") + std::strerror(errno) +
                         "); check the disk or copy the file again");
  if (bytes.empty())
    throw InputError(file.string(), 0, "is empty; write the scene again or name another file");
  return bytes;
}

}  // namespace cigsim
