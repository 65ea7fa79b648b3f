#include "keyword_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/formats/deck/deck_files.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "deck_cases.hpp"
#include "fields.hpp"
#include "included_files.hpp"
#include "keyword_scanner.hpp"

namespace pinball {

namespace {

constexpr std::size_t deepest_include = 64;

bool is_parameter(const std::string& name) {
  return name.starts_with("PARAMETER") && name != "PARAMETER_TYPE" && name != "PARAMETER_DUPLICATION";
}

class KeywordReader {
 public:
  KeywordReader(const std::string& path, std::optional<std::int64_t> chosen_case)
      : chosen_(chosen_case), cases_(chosen_case), included_(path) {}

  KeywordDeck read(std::string bytes, const std::string& path) {
    add_file(std::move(bytes), path, nullptr, {});
    keep_case();
    deck_.unread = included_.unread();
    return std::move(deck_);
  }

 private:
  struct Found {
    KeywordBlock block;
    DeckCases::Numbers cases;  ///< that it belongs to; none: to all
  };

  void add_file(std::string bytes, const std::string& path, const std::shared_ptr<const DeckTransform>& transform,
                KeywordScanner::Widths widths) {
    deck_.files.push_back({path, hash_of_bytes(bytes)});
    const auto text = deck_text_of(std::move(bytes));
    deck_.texts.push_back(text);
    open_.push_back(path);
    KeywordScanner scanner(*text, path, widths);
    KeywordBlock block;
    std::string after;
    while (scanner.next(block, after)) {
      block.transform = transform;
      take_in(block, after);
    }
    if (const auto place = scanner.behind_end()) deck_.behind_end.push_back(*place);
    open_.pop_back();
  }

  void take_in(KeywordBlock& block, const std::string& after) {
    if (cases_.take_in(block, deck_.parameters)) return;
    DeckCases::Numbers cases = cases_.cases_here(after);
    cases_.know(cases);
    if (IncludedFiles::reads(block.name)) {
      if (cases_.takes(cases)) include(block);
    } else if (is_parameter(block.name)) {
      if (cases_.takes(cases)) deck_.parameters.read(block);
    } else {
      if (block.name == "PARAMETER_DUPLICATION") deck_.parameters.read_duplication(block);
      found_.push_back({std::move(block), std::move(cases)});
    }
  }

  /// An included file has the columns of the one that includes it, unless *INCLUDE% or its own *KEYWORD says otherwise.
  void include(const KeywordBlock& block) {
    for (const IncludedFile& file : included_.read(block, deck_.parameters, block.transform)) {
      const std::string path = included_.find(file.name, open_.back());
      if (open_.size() > deepest_include || std::ranges::count(open_, path) != 0)
        fail_at(file.place, fmt::format("*INCLUDE {}: the file includes itself", file.name));
      add_file(files_.open(path, &file.place, "*INCLUDE"), path, file.transform, {block.wide, block.twenty});
    }
  }

  /// A keyword of the chosen case takes the place of the same keyword outside of all cases: later ones count, and that
  /// of the case is the later one.
  void keep_case() {
    deck_.cases = cases_.numbers();
    deck_.case_is_empty = cases_.chosen_is_empty();
    if (chosen_ && std::ranges::count(deck_.cases, *chosen_) == 0) {
      throw InputError(fmt::format(
          "{}: --case {}: {}", deck_.files.front().path, *chosen_,
          deck_.cases.empty() ? "the deck has no cases" : fmt::format("it has {}", fmt::join(deck_.cases, ", "))));
    }
    std::vector<KeywordBlock> of_case;
    for (Found& one : found_) {
      if (one.cases.empty()) {
        deck_.blocks.push_back(std::move(one.block));
      } else if (cases_.takes(one.cases)) {
        of_case.push_back(std::move(one.block));
      } else {
        ++deck_.left_out_of_case;
      }
    }
    for (KeywordBlock& block : of_case) {
      block.of_case = true;
      deck_.blocks.push_back(std::move(block));
    }
  }

  std::optional<std::int64_t> chosen_;
  KeywordDeck deck_;
  DeckCases cases_;
  IncludedFiles included_;
  DeckFiles files_;
  std::vector<Found> found_;
  std::vector<std::string> open_;  ///< files that are being read, each included by the one before
};

}  // namespace

KeywordDeck read_keyword_deck(const std::string& path, std::optional<std::int64_t> chosen_case) {
  return KeywordReader(path, chosen_case).read(bytes_of_file(path), path);
}

KeywordDeck parse_keyword_deck(std::string text, const std::string& name, std::optional<std::int64_t> chosen_case) {
  return KeywordReader(name, chosen_case).read(std::move(text), name);
}

}  // namespace pinball
