#include "deck_files.hpp"

#include <fmt/format.h>

#include <solver/base/error.hpp>
#include <solver/mesh/file/input_file.hpp>

namespace pinball {

namespace {

constexpr std::size_t most_files = 10'000;

}  // namespace

std::string DeckFiles::open(const std::string& path, const DeckPlace* from, const std::string& keyword) {
  if (from == nullptr) return bytes_of_file(path);
  if (++files_ >= most_files)
    fail_at(*from, fmt::format("{} {}: the deck includes more than {} files", keyword, path, most_files));
  try {
    std::string bytes = bytes_of_file(path);
    require_memory("all included files", bytes_ += bytes.size());
    return bytes;
  } catch (const InputError& error) {
    fail_at(*from, fmt::format("{} {}", keyword, error.what()));
  }
}

}  // namespace pinball
