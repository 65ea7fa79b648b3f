#include "abaqus_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <solver/base/error.hpp>
#include <solver/formats/deck/deck_files.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "abaqus_parameters.hpp"

namespace pinball {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_abaqus_include = 64;

/// Takes a line, with its end, off a text.
std::string_view take_line(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return line;
}

bool is_comment(std::string_view line) { return trimmed(line).starts_with("**"); }

bool is_keyword(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '*' && line.substr(first, 2) != "**";
}

/// The keyword for people: upper case, one blank between words.
std::string title_of(std::string_view words) {
  std::string title;
  for (const char c : upper_case(trimmed(words))) {
    const bool blank = c == ' ' || c == '\t';
    if (!blank || title.back() != ' ') title += blank ? ' ' : c;
  }
  return title;
}

class AbaqusReader {
 public:
  AbaqusDeck read(std::shared_ptr<const std::string> text, const std::string& path) {
    folder_ = fs::path(path).parent_path();
    add_file(std::move(text), path);
    read_parameters();
    if (deck_.blocks.empty()) throw InputError(path + ": expected Abaqus input, there is no keyword in it");
    require_closed();
    for (const std::string& note : parameters_.notes()) deck_.notes.push_back(note);
    return std::move(deck_);
  }

 private:
  void add_file(std::shared_ptr<const std::string> text, const std::string& path) {
    deck_.texts.push_back(text);
    deck_.files.push_back({path, hash_of_bytes(*text)});
    open_.push_back(path);
    std::string_view rest = *text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    DeckPlace place{std::make_shared<const std::string>(path), 0};
    while (!rest.empty()) {
      take_data(rest, place);
      if (!rest.empty()) take_keyword(rest, place);
    }
    open_.pop_back();
  }

  /// Lines up to the next keyword: those of the keyword before, also of one in the file that includes this one.
  void take_data(std::string_view& rest, DeckPlace& place) {
    const std::string_view begin = rest;
    const DeckPlace before = place;
    while (!rest.empty() && !is_keyword(rest.substr(0, rest.find('\n')))) {
      const std::string_view line = take_line(rest);
      ++place.line;
      if (deck_.blocks.empty() && !trimmed(line).empty() && !is_comment(line)) fail_foreign(line, place);
    }
    const std::size_t size = begin.size() - rest.size();
    if (size == 0 || deck_.blocks.empty()) return;
    std::string_view lines = begin.substr(0, size);
    AbaqusBlock& block = deck_.blocks.back();
    if (has_names(block) && lines.find('<') != std::string_view::npos) {
      deck_.texts.push_back(std::make_shared<const std::string>(parameters_.replaced_lines(lines, before)));
      lines = *deck_.texts.back();
    }
    block.data.push_back({lines, before});
  }

  /// Whether < and > stand around the names of parameters in its data lines.
  static bool has_names(const AbaqusBlock& block) { return block.name != "HEADING" && block.name != "PARAMETER"; }

  /// *PARAMETER is read where it ends, and left behind where it says nothing but names.
  void read_parameters() {
    if (deck_.blocks.empty() || deck_.blocks.back().name != "PARAMETER") return;
    if (!deck_.blocks.back().parameters.empty()) return;  // which are refused
    parameters_.read(deck_.blocks.back());
    deck_.blocks.pop_back();
  }

  [[noreturn]] static void fail_foreign(std::string_view line, const DeckPlace& place) {
    if (trimmed(line).starts_with('$'))
      fail_at(place, "expected Abaqus input, this is an LS-DYNA keyword file: name it .k, .key or .dyn");
    fail_at(place, fmt::format("expected a keyword such as *HEADING, got \"{}\"", trimmed(line).substr(0, 40)));
  }

  void take_keyword(std::string_view& rest, DeckPlace& place) {
    read_parameters();
    AbaqusBlock block;
    std::string line(trimmed(take_line(rest)));
    ++place.line;
    block.place = place;
    bool ends_in_comma = false;
    while (goes_on(line) && !ends_in_comma) {
      if (rest.empty()) fail_at(block.place, "expected the rest of a keyword line that ends in a comma");
      const std::string_view more = trimmed(rest.substr(0, rest.find('\n')));
      ends_in_comma = !is_comment(more) && !has_parameters(more);
      if (ends_in_comma) continue;
      take_line(rest);
      ++place.line;
      if (!is_comment(more)) line += more;
    }
    line = parameters_.replaced(line, block.place);
    read_keyword_line(block, ends_in_comma ? line.substr(0, line.rfind(',')) : line);
    if (ends_in_comma)
      deck_.notes.push_back(fmt::format("{} ({}): its line ends in a comma, and no parameter follows: it is at its end",
                                        block.star_name(), block.place.text()));
    if (block.name == "INCLUDE") {
      open_included(block.require("INPUT"), block.place);
      return;
    }
    enter(block);
    const std::optional<std::string> input = takes_input(block.name) ? block.value("INPUT") : std::nullopt;
    deck_.blocks.push_back(std::move(block));
    if (input) open_included(*input, DeckPlace(deck_.blocks.back().place));
  }

  /// Whether a line goes on with what one before began that ends in a comma. A parameter begins with a letter: what
  /// begins with another sign is the next keyword, or data of this one, as CalculiX has it.
  static bool has_parameters(std::string_view line) {
    return line.empty() || std::isalpha(static_cast<unsigned char>(line.front())) != 0;
  }

  static bool takes_input(const std::string& name) { return name != "RESTART" && name != "IMPORT"; }

  static void read_keyword_line(AbaqusBlock& block, const std::string& line) {
    const std::vector<std::string_view> words = entries_of(std::string_view(line).substr(1));
    if (words.empty() || words.front().empty()) fail_at(block.place, "expected a keyword behind the star");
    block.title = title_of(words.front());
    block.name = squeezed(words.front());
    if (block.name == "DYNAMICTEMPERATURE-DISPLACEMENT") block.name = "DYNAMIC";  // told apart by its title
    if (block.name == "KEYWORD" || block.name.find('_') != std::string::npos)
      fail_at(block.place, fmt::format("*{}: expected Abaqus input, this is a keyword of an LS-DYNA file: name it .k, "
                                       ".key or .dyn",
                                       block.title));
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t equals = words[i].find('=');
      const std::string_view value =
          equals == std::string_view::npos ? std::string_view{} : trimmed(words[i].substr(equals + 1));
      block.parameters.emplace_back(squeezed(words[i].substr(0, equals)), std::string(value));
    }
  }

  /// Where a keyword stands, and what it opens or closes.
  void enter(AbaqusBlock& block) {
    const std::string& name = block.name;
    if (name == "PART") open_part(part_, block);
    if (name == "INSTANCE") open_part(instance_, block);
    if (name == "ASSEMBLY") open_assembly(block);
    if (name == "STEP") open_step(block);
    block.part = part_;
    block.instance = instance_;
    block.assembly = assembly_;
    block.step = in_step_ ? steps_ : 0;
    if (name == "ENDPART") close(part_, block);
    if (name == "ENDINSTANCE") close(instance_, block);
    if (name == "ENDASSEMBLY") close(assembly_, block);
    if (name == "ENDSTEP") close(in_step_, block);
  }

  void open_part(std::string& open, const AbaqusBlock& block) {
    if (!part_.empty() || !instance_.empty())
      fail_at(block.place, block.star_name() + ": a *PART or an *INSTANCE before it is not closed");
    open = label_key(block.require("NAME"));
    opened_ = block.place;
  }

  static void close(std::string& open, const AbaqusBlock& block) {
    if (open.empty()) fail_at(block.place, block.star_name() + ": nothing is open that it closes");
    open.clear();
  }

  static void close(bool& open, const AbaqusBlock& block) {
    if (!open) fail_at(block.place, block.star_name() + ": nothing is open that it closes");
    open = false;
  }

  void open_assembly(const AbaqusBlock& block) {
    if (assembly_) fail_at(block.place, "*ASSEMBLY: the one before it is not closed by *END ASSEMBLY");
    assembly_ = true;
    assembly_opened_ = block.place;
  }

  void open_step(const AbaqusBlock& block) {
    if (in_step_) fail_at(block.place, "*STEP: the step before it is not closed by *END STEP");
    in_step_ = true;
    step_opened_ = block.place;
    ++steps_;
  }

  void require_closed() const {
    if (!part_.empty()) fail_at(opened_, "*PART: expected *END PART before the end of the deck");
    if (!instance_.empty()) fail_at(opened_, "*INSTANCE: expected *END INSTANCE before the end of the deck");
    if (assembly_) fail_at(assembly_opened_, "*ASSEMBLY: expected *END ASSEMBLY before the end of the deck");
    if (in_step_) fail_at(step_opened_, "*STEP: expected *END STEP before the end of the deck");
  }

  void open_included(const std::string& name, const DeckPlace& place) {
    const std::string path = search(label_text(name));
    if (open_.size() > deepest_abaqus_include || std::ranges::count(open_, path) != 0)
      fail_at(place, fmt::format("INPUT={}: the file includes itself", name));
    add_file(std::make_shared<const std::string>(files_.open(path, &place, "INPUT=")), path);
  }

  /// Beside the file that names it, or beside the deck.
  std::string search(const std::string& name) const {
    const fs::path file(name);
    if (file.is_absolute()) return name;
    std::error_code none;
    for (const fs::path& folder : {fs::path(open_.back()).parent_path(), folder_}) {
      if (fs::is_regular_file(folder / file, none)) return (folder / file).lexically_normal().string();
    }
    return (folder_ / file).lexically_normal().string();
  }

  AbaqusDeck deck_;
  AbaqusParameters parameters_;
  fs::path folder_;
  DeckFiles files_;
  std::vector<std::string> open_;
  std::string part_, instance_;
  DeckPlace opened_, assembly_opened_, step_opened_;
  bool assembly_ = false, in_step_ = false;
  int steps_ = 0;
};

}  // namespace

AbaqusDeck read_abaqus_deck(const std::string& path) { return parse_abaqus_deck(bytes_of_file(path), path); }

AbaqusDeck parse_abaqus_deck(std::string text, const std::string& name) {
  return AbaqusReader().read(std::make_shared<const std::string>(std::move(text)), name);
}

}  // namespace pinball
