#include "mesh_format.hpp"

#include <cctype>
#include <filesystem>

#include "words.hpp"

namespace pinball {

namespace {

/// visit(ending, format) for all that are known.
template <class Visit>
void for_endings(const Visit& visit) {
  for (const KnownMeshFormat& known : known_mesh_formats) {
    for_words(known.endings, [&](std::string_view ending) { visit(std::string(ending), known.format); });
  }
}

}  // namespace

std::optional<MeshFormat> format_by_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::optional<MeshFormat> found;
  for_endings([&](const std::string& known, MeshFormat format) {
    if (known == ending) found = format;
  });
  return found;
}

std::string known_endings() {
  std::string all;
  for_endings([&all](const std::string& known, MeshFormat) { all += (all.empty() ? "" : ", ") + known; });
  return all;
}

}  // namespace pinball
