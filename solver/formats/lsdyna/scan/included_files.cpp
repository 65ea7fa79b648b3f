#include "included_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>

#include "fields.hpp"

namespace pinball {

namespace fs = std::filesystem;

namespace {

/// A name that ends in " +" goes on in the next line.
std::string file_name(Card card, Cards& cards) {
  std::string name(trimmed(card.text));
  while (name.ends_with(" +")) {
    name.resize(name.size() - 2);
    name = std::string(trimmed(name)) + std::string(trimmed(cards.require("the rest of the file's name").text));
  }
  return name;
}

/// Blank and 0 are 1; products of powers of the others have to be numbers. Temperatures are not computed, but one that
/// is converted is meant to be.
DeckUnits read_units(const Fields& fields) {
  const auto factor = [&fields](const char* name) {
    const double value = fields.number(name);
    if (value == 0) return 1.0;
    if (value < 1e-30 || value > 1e30)
      fields.fail(name, fmt::format("expected a number from 1e-30 to 1e30, got {:.6g}", value));
    return value;
  };
  const auto temperature = deck_number(fields.text("FCTTEM"));
  if (!fields.blank("FCTTEM") && temperature != 0.0 && temperature != 1.0)
    fields.fail("FCTTEM",
                fmt::format("expected 1 or a blank, for heat is not computed, got \"{}\"", fields.text("FCTTEM")));
  return {factor("FCTMAS"), factor("FCTTIM"), factor("FCTLEN")};
}

/// Of the four lines behind the name of the file.
std::shared_ptr<const DeckTransform> transform_of(const std::array<Card, 4>& lines, const Parameters& parameters) {
  auto transform = std::make_shared<DeckTransform>();
  const auto& [offsets, more, factors, number] = lines;
  const Fields ids(offsets, parameters, layout::include_offsets);
  transform->node = ids.integer("IDNOFF");
  transform->element = ids.integer("IDEOFF");
  transform->part = ids.integer("IDPOFF");
  transform->material = ids.integer("IDMOFF");
  transform->set = ids.integer("IDSOFF");
  transform->curve = ids.integer("IDFOFF");
  transform->define = ids.integer("IDDOFF");
  transform->other = Fields(more, parameters, layout::include_other).integer("IDROFF");
  transform->units = read_units(Fields(factors, parameters, layout::include_units));
  transform->transformation = Fields(number, parameters, layout::include_transformation).integer("TRANID");
  return transform;
}

std::shared_ptr<const DeckTransform> read_transform(Cards& cards, const Parameters& parameters,
                                                    std::vector<UnreadLine>& unread) {
  std::array<Card, 4> lines;
  ReadingLog log;
  for (Card& line : lines) {
    line = cards.next_or_blank();
    line.log = &log;
  }
  auto transform = transform_of(lines, parameters);
  for (const Card& line : lines) unread.push_back({line.block->star_name(), line.place, log.left_of(line.text.data())});
  return transform;
}

}  // namespace

bool IncludedFiles::reads(const std::string& name) {
  return name == "INCLUDE" || name == "INCLUDE_TRANSFORM" || name == "INCLUDE_PATH" || name == "INCLUDE_PATH_RELATIVE";
}

std::vector<IncludedFile> IncludedFiles::read(const KeywordBlock& block, const Parameters& parameters,
                                              const std::shared_ptr<const DeckTransform>& outer) {
  Cards cards(block);
  std::vector<IncludedFile> files;
  if (block.name == "INCLUDE_TRANSFORM") {
    const auto card = cards.next_filled();
    if (!card) fail_at(block.place, "*INCLUDE_TRANSFORM: expected the name of a file");
    if (outer) fail_at(block.place, "*INCLUDE_TRANSFORM inside of another one is not read");
    const std::string name = file_name(*card, cards);
    files.push_back({name, card->place, read_transform(cards, parameters, unread_)});
    return files;
  }
  while (const auto card = cards.next_filled()) {
    const std::string name = file_name(*card, cards);
    if (block.name == "INCLUDE") {
      files.push_back({name, card->place, outer});
    } else {
      paths_.emplace_back(name);
    }
  }
  return files;
}

std::string IncludedFiles::find(const std::string& name, const std::string& including) const {
  std::string with_slashes = name;
  std::ranges::replace(with_slashes, '\\', '/');  // of Windows
  const fs::path file(with_slashes);
  if (file.is_absolute()) return with_slashes;
  std::vector<fs::path> folders{fs::path(including).parent_path(), folder_};
  for (const fs::path& path : paths_) folders.push_back(path.is_absolute() ? path : folder_ / path);
  std::error_code none;
  for (const fs::path& folder : folders) {
    if (fs::is_regular_file(folder / file, none)) return (folder / file).lexically_normal().string();
  }
  return (folders.front() / file).lexically_normal().string();
}

}  // namespace pinball
