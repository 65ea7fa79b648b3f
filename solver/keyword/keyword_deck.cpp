#include "keyword_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <solver/base/error.hpp>

#include "fields.hpp"

namespace pinball {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_include = 64;

std::shared_ptr<const std::string> text_of(const std::string& path, const DeckPlace* from) {
  std::error_code problem;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || fs::is_directory(path, problem)) {
    const std::string message = path + ": no such file, or it cannot be read";
    if (from != nullptr) fail_at(*from, "*INCLUDE " + message);
    throw InputError(message);
  }
  auto text = std::make_shared<std::string>(static_cast<std::size_t>(file.tellg()), '\0');
  file.seekg(0);
  file.read(text->data(), static_cast<std::streamsize>(text->size()));
  if (!file) throw InputError(path + ": cannot be read");
  return text;
}

/// Takes an ending such as "_TITLE" off a name.
bool take_ending(std::string& name, std::string_view ending) {
  if (!name.ends_with(ending) || name.size() == ending.size()) return false;
  name.resize(name.size() - ending.size());
  return true;
}

class Reader {
 public:
  explicit Reader(std::optional<std::int64_t> chosen_case) : chosen_(chosen_case) {}

  KeywordDeck read(std::shared_ptr<const std::string> text, const std::string& path) {
    folder_ = fs::path(path).parent_path();
    add_file(std::move(text), path, nullptr);
    keep_case();
    return std::move(deck_);
  }

 private:
  struct Found {
    KeywordBlock block;
    std::set<std::int64_t> cases;  ///< that it belongs to; none: to all
  };

  void add_file(std::shared_ptr<const std::string> text, const std::string& path,
                const std::shared_ptr<const DeckTransform>& transform) {
    deck_.texts.push_back(text);
    deck_.files.push_back(path);
    open_.push_back(path);
    const auto name = std::make_shared<const std::string>(path);
    std::string_view rest = *text;
    DeckPlace place{name, 0};
    skip_to_keyword(rest, place);
    bool wide = false;
    while (!rest.empty()) {
      KeywordBlock block;
      block.transform = transform;
      std::string after;
      take_block(rest, place, block, after);
      block.wide |= wide;
      if (block.name == "END") break;
      if (block.name == "KEYWORD") {
        wide |= read_formats(after, block.place);
        continue;
      }
      take_in(block, after, transform);
    }
    open_.pop_back();
  }

  /// What stands before the first keyword: blank lines and comments alone.
  static void skip_to_keyword(std::string_view& rest, DeckPlace& place) {
    while (!rest.empty() && rest.front() != '*') {
      const std::size_t end = rest.find('\n');
      const std::string_view line = trimmed(rest.substr(0, end));
      if (!line.empty() && line.front() != '$') {
        ++place.line;
        fail_at(place, "expected a keyword such as *KEYWORD, got \"" + std::string(line.substr(0, 40)) + '"');
      }
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      ++place.line;
    }
  }

  /// Takes a keyword and its lines off the text; place: of the line before it, and then of its last one.
  static void take_block(std::string_view& rest, DeckPlace& place, KeywordBlock& block, std::string& after) {
    std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++place.line;
    block.place = place;
    const std::size_t name_end = std::min(line.find_first_of(" \t\r,("), line.size());
    block.name = upper_case(line.substr(1, name_end - 1));
    after = upper_case(trimmed(line.substr(name_end)));
    read_options(block);

    std::size_t size = 0;
    while (size < rest.size() && rest[size] != '*') {
      ++place.line;
      end = rest.find('\n', size);
      size = end == std::string_view::npos ? rest.size() : end + 1;
    }
    block.body = rest.substr(0, size);
    rest.remove_prefix(size);
  }

  static void read_options(KeywordBlock& block) {
    std::string& name = block.name;
    if (take_ending(name, "+")) fail_at(block.place, '*' + name + "+: cards of twenty columns (LONG=Y) are not read");
    if (take_ending(name, "-")) {
    }  // standard columns, said once more
    block.wide = take_ending(name, "%");
    bool more = true;
    while (more) {
      more = false;
      if (take_ending(name, "_TITLE")) more = block.title = true;
      if (take_ending(name, "_ID")) more = block.id = true;
    }
  }

  /// What follows *KEYWORD: returns whether numbers of nodes and elements have ten columns.
  static bool read_formats(const std::string& after, const DeckPlace& place) {
    std::string squeezed;
    for (const char c : after) {
      if (c != ' ' && c != '\t') squeezed += c;
    }
    const std::size_t at = squeezed.find("LONG=");
    if (at != std::string::npos && squeezed.substr(at, 6) != "LONG=S")
      fail_at(place, "*KEYWORD LONG=" + squeezed.substr(at + 5, 1) + ": cards of twenty columns are not read");
    return squeezed.find("I10=Y") != std::string::npos;
  }

  void take_in(KeywordBlock& block, const std::string& after, const std::shared_ptr<const DeckTransform>& transform) {
    std::set<std::int64_t> cases = open_cases_;
    if (const std::size_t at = after.find("CID="); at != std::string::npos) {
      if (const auto cid = deck_integer(trimmed(after.substr(at + 4)))) cases.insert(*cid);
    }
    const std::string& name = block.name;
    if (name.starts_with("CASE_BEGIN_") || name.starts_with("CASE_END_")) {
      change_case(block);
    } else if (name == "CASE") {
      read_case(block);
    } else if (name.starts_with("INCLUDE")) {
      if (cases.empty() || is_chosen(cases)) include(block, transform);
    } else if (name.starts_with("PARAMETER") && name != "PARAMETER_DUPLICATION" && name != "PARAMETER_TYPE") {
      if (cases.empty() || is_chosen(cases)) read_parameters(block);
    } else {
      found_.push_back({std::move(block), std::move(cases)});
    }
  }

  void read_parameters(KeywordBlock block) {
    while (take_ending(block.name, "_LOCAL") || take_ending(block.name, "_MUTABLE") ||
           take_ending(block.name, "_NOECHO")) {
    }
    if (block.name != "PARAMETER" && block.name != "PARAMETER_EXPRESSION")
      fail_at(block.place, '*' + block.name + " is not read");
    deck_.parameters.read(block);
  }

  void change_case(const KeywordBlock& block) {
    const bool begins = block.name.starts_with("CASE_BEGIN_");
    const auto number = deck_integer(std::string_view(block.name).substr(begins ? 11 : 9));
    if (!number) fail_at(block.place, '*' + block.name + ": expected the number of a case");
    if (begins) {
      open_cases_.insert(*number);
    } else if (open_cases_.erase(*number) == 0) {
      fail_at(block.place, '*' + block.name + ": no such case has begun");
    }
    case_ids_.insert(*number);
  }

  /// Number and name; a line of its own command; the numbers of the parts of the deck that belong to it.
  void read_case(const KeywordBlock& block) {
    Cards cards(block);
    const std::int64_t number = Fields(cards.require("the number of the case"), deck_.parameters).integer(0, "caseid");
    cards.next();
    std::set<std::int64_t>& members = cases_[number];
    while (const std::optional<Card> card = cards.next_filled()) {
      const Fields fields(*card, deck_.parameters);
      for (std::size_t i = 0; i < 8; ++i) {
        if (const auto id = deck_integer(fields.text(i))) members.insert(*id);
      }
    }
  }

  bool is_chosen(const std::set<std::int64_t>& cases) const {
    const std::set<std::int64_t> chosen = chosen_ids();
    return std::any_of(cases.begin(), cases.end(), [&](std::int64_t id) { return chosen.contains(id); });
  }

  std::set<std::int64_t> chosen_ids() const {
    if (!chosen_) return {};
    const auto found = cases_.find(*chosen_);
    return found == cases_.end() ? std::set<std::int64_t>{*chosen_} : found->second;
  }

  void keep_case() {
    for (const Found& one : found_) case_ids_.insert(one.cases.begin(), one.cases.end());
    for (const auto& [number, members] : cases_) deck_.cases.push_back(number);
    for (const std::int64_t id : case_ids_) {
      if (!cases_.contains(id)) deck_.cases.push_back(id);
    }
    if (chosen_ && !std::ranges::count(deck_.cases, *chosen_)) {
      throw InputError(fmt::format(
          "{}: --case {}: {}", deck_.files.front(), *chosen_,
          deck_.cases.empty() ? "the deck has no cases" : fmt::format("it has {}", fmt::join(deck_.cases, ", "))));
    }
    // A keyword of the chosen case takes the place of the same keyword outside of all cases: later ones count, and
    // that of the case is the later one.
    std::vector<KeywordBlock> of_case;
    for (Found& one : found_) {
      if (one.cases.empty()) {
        deck_.blocks.push_back(std::move(one.block));
      } else if (is_chosen(one.cases)) {
        of_case.push_back(std::move(one.block));
      } else {
        ++deck_.left_out_of_case;
      }
    }
    for (KeywordBlock& block : of_case) deck_.blocks.push_back(std::move(block));
  }

  void include(const KeywordBlock& block, const std::shared_ptr<const DeckTransform>& outer) {
    Cards cards(block);
    if (block.name == "INCLUDE_PATH" || block.name == "INCLUDE_PATH_RELATIVE") {
      while (const auto card = cards.next_filled()) paths_.emplace_back(trimmed(card->text));
      return;
    }
    if (block.name == "INCLUDE_TRANSFORM") {
      include_transformed(cards, outer, block.place);
      return;
    }
    if (block.name != "INCLUDE") fail_at(block.place, '*' + block.name + " is not read");
    while (const auto card = cards.next_filled()) open_included(file_name(*card, cards), card->place, outer);
  }

  /// A name that ends in " +" goes on in the next line.
  static std::string file_name(Card card, Cards& cards) {
    std::string name(trimmed(card.text));
    while (name.ends_with(" +")) {
      name.resize(name.size() - 2);
      name = std::string(trimmed(name)) + std::string(trimmed(cards.require("the rest of the file's name").text));
    }
    return name;
  }

  void include_transformed(Cards& cards, const std::shared_ptr<const DeckTransform>& outer, const DeckPlace& keyword) {
    const auto card = cards.next_filled();
    if (!card) fail_at(keyword, "*INCLUDE_TRANSFORM: expected the name of a file");
    const std::string name = file_name(*card, cards);
    if (outer) fail_at(keyword, "*INCLUDE_TRANSFORM inside of another one is not read");
    auto transform = std::make_shared<DeckTransform>();
    const Card offsets = cards.next_or_blank(), more = cards.next_or_blank(), factors = cards.next_or_blank(),
               number = cards.next_or_blank();
    const Fields ids(offsets, deck_.parameters);
    const auto offset = [&ids](std::size_t field, const char* what) { return ids.integer(field, what, 0); };
    transform->node = offset(0, "idnoff");
    transform->element = offset(1, "ideoff");
    transform->part = offset(2, "idpoff");
    transform->material = offset(3, "idmoff");
    transform->set = offset(4, "idsoff");
    transform->define = offset(6, "iddoff");
    transform->other = Fields(more, deck_.parameters).integer(0, "idroff", 0);
    const Fields scales(factors, deck_.parameters);
    for (std::size_t i = 0; i < 3; ++i) {
      if (scales.number(i, "fctmas, fcttim, fctlen", 1.0) != 1.0 && scales.number(i, "factor", 1.0) != 0.0)
        fail_at(factors.place, "*INCLUDE_TRANSFORM: other units of an included file are not read");
    }
    transform->transformation = Fields(number, deck_.parameters).integer(0, "tranid", 0);
    open_included(name, card->place, transform);
  }

  void open_included(const std::string& name, const DeckPlace& place,
                     const std::shared_ptr<const DeckTransform>& transform) {
    const std::string path = search(name);
    if (open_.size() > deepest_include || std::ranges::count(open_, path) != 0)
      fail_at(place, fmt::format("*INCLUDE {}: the file includes itself", name));
    add_file(text_of(path, &place), path, transform);
  }

  std::string search(const std::string& name) const {
    const fs::path file(name);
    if (file.is_absolute()) return name;
    std::vector<fs::path> folders{fs::path(open_.back()).parent_path(), folder_};
    for (const fs::path& path : paths_) folders.push_back(path.is_absolute() ? path : folder_ / path);
    std::error_code none;
    for (const fs::path& folder : folders) {
      if (fs::is_regular_file(folder / file, none)) return (folder / file).lexically_normal().string();
    }
    return (folders.front() / file).lexically_normal().string();
  }

  std::optional<std::int64_t> chosen_;
  KeywordDeck deck_;
  std::vector<Found> found_;
  fs::path folder_;
  std::vector<fs::path> paths_;
  std::vector<std::string> open_;
  std::set<std::int64_t> open_cases_, case_ids_;
  std::map<std::int64_t, std::set<std::int64_t>> cases_;
};

}  // namespace

KeywordDeck read_keyword_deck(const std::string& path, std::optional<std::int64_t> chosen_case) {
  return Reader(chosen_case).read(text_of(path, nullptr), path);
}

KeywordDeck parse_keyword_deck(std::string text, const std::string& name, std::optional<std::int64_t> chosen_case) {
  return Reader(chosen_case).read(std::make_shared<const std::string>(std::move(text)), name);
}

}  // namespace pinball
