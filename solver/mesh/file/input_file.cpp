#include "input_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/base/state_hash.hpp>

namespace pinball {

namespace {

namespace fs = std::filesystem;

/// Of this machine; 0: not known.
std::uintmax_t memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGE_SIZE);
  return pages > 0 && size > 0 ? static_cast<std::uintmax_t>(pages) * static_cast<std::uintmax_t>(size) : 0;
}

}  // namespace

void require_memory(const std::string& path, std::uintmax_t bytes) {
  const std::uintmax_t memory = memory_bytes();
  if (memory > 0 && bytes > memory)
    throw InputError(fmt::format("{}: {} bytes are more than this machine's memory can hold", path, bytes));
}

void require_file(const std::string& path) {
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (fs::is_regular_file(status)) return;
  if (fs::is_directory(status)) throw InputError(path + ": expected a file, got a folder");
  if (fs::exists(status)) throw InputError(path + ": expected a file, got a pipe or a device");
  throw InputError(path + ": no such file, or it cannot be read");
}

std::uint64_t hash_of_bytes(std::string_view bytes) {
  StateHash hash;
  hash.add(bytes.data(), bytes.size());
  return hash.value();
}

std::uint64_t hash_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> piece(1U << 16);
  StateHash hash;
  while (file) {
    file.read(piece.data(), piece.size());
    hash.add(piece.data(), file.gcount());
  }
  if (!file.eof()) throw InputError(path + ": cannot be read");
  return hash.value();
}

std::string bytes_of_file(const std::string& path) {
  require_file(path);
  std::error_code problem;
  const std::uintmax_t size = fs::file_size(path, problem);
  std::ifstream file(path, std::ios::binary);
  if (problem || !file) throw InputError(path + ": no such file, or it cannot be read");
  require_memory(path, size);
  std::string bytes(size, '\0');
  file.read(bytes.data(), bytes.size());
  if (!file) throw InputError(path + ": cannot be read");
  return bytes;
}

}  // namespace pinball
