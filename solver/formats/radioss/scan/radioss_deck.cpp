#include "radioss_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/deck/behind_end.hpp>
#include <solver/formats/deck/deck_files.hpp>
#include <solver/formats/deck/indented_keyword.hpp>
#include <solver/formats/deck/number_text.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "radioss_fields.hpp"
#include "radioss_names.hpp"

namespace pinball {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view include = "#include";
constexpr std::size_t deepest_radioss_include = 15;  // as the starter has it
constexpr std::int64_t oldest_version = 51;          // from which on fields have ten and twenty columns

constexpr CardLayout run_name_line{layout::text("run_name").columns(100)};
constexpr CardLayout version_line{layout::whole("Invers"), layout::whole("Irun")};

/// Cuts "/MAT/LAW1/3" into words and the numbers behind them.
void read_header(std::string_view line, RadiossBlock& block) {
  std::string name;
  std::string_view rest = trimmed(line);
  block.title = std::string(rest);
  while (!block.title.empty() && (block.title.back() == '/' || block.title.back() == ' ')) block.title.pop_back();
  while (!rest.empty()) {
    rest.remove_prefix(1);  // a slash
    const std::size_t end = rest.find('/');
    const std::string_view word = trimmed(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end);
    const std::optional<std::int64_t> number = deck_integer(word);
    if (number && !name.empty()) {
      block.numbers.push_back(*number);
    } else if (!word.empty()) {
      if (!name.empty()) name += '/';
      name += upper_case(word);
    }
    if (name == "RUN") break;  // what follows is a name, whatever it looks like
  }
  block.name = radioss_name(name);
  block.titled = radioss_has_title(block.name);
}

class RadiossReader {
 public:
  explicit RadiossReader(const std::string& path) : folder_(fs::path(path).parent_path()) {}

  void read_starter(std::shared_ptr<const std::string> text, const std::string& path) {
    add_file(std::move(text), path);
    if (deck_.blocks.empty()) throw InputError(path + ": expected Radioss input, there is no keyword in it");
    require_version(path);
  }

  void read_engine(const std::string& path) {
    deck_.engine = path;
    in_engine_ = true;
    const std::size_t files = deck_.files.size();
    add_file(std::make_shared<const std::string>(bytes_of_file(path)), path);
    deck_.files.resize(files);  // says nothing of the mesh
  }

  RadiossDeck take() { return std::move(deck_); }

 private:
  void add_file(std::shared_ptr<const std::string> text, const std::string& path) {
    deck_.texts.push_back(text);
    deck_.files.push_back({path, hash_of_bytes(*text)});
    open_.push_back(path);
    std::string_view rest = *text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    DeckPlace place{std::make_shared<const std::string>(path), 0};
    while (!rest.empty() && !ended_) {
      take_data(rest, place);
      if (!rest.empty()) take_special(rest, place);
    }
    if (ended_) {
      if (const auto behind = first_behind_end(rest, place, "/END", "#$")) deck_.behind_end.push_back(*behind);
    }
    ended_ = false;  // one that is included ends, and not what includes it
    open_.pop_back();
  }

  /// An #include has no case, as OpenRadioss reads it.
  static bool is_special(std::string_view line) {
    return line.starts_with('/') || (line.starts_with('#') && lower_case(line.substr(0, include.size())) == include);
  }

  static std::string_view first_line(std::string_view text) { return text.substr(0, text.find('\n')); }

  /// Lines up to the next keyword: those of the keyword before, also of one in the file that includes this one.
  void take_data(std::string_view& rest, DeckPlace& place) {
    const std::string_view begin = rest;
    const DeckPlace before = place;
    while (!rest.empty() && !is_special(first_line(rest))) {
      const std::string_view line = first_line(rest);
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      ++place.line;
      refuse_indented_keyword(line, '/', place);
      if (deck_.blocks.empty() && !trimmed(line).empty() && !is_radioss_comment(line)) fail_foreign(line, place);
    }
    const std::size_t size = begin.size() - rest.size();
    if (size > 0 && !deck_.blocks.empty()) deck_.blocks.back().data.push_back({begin.substr(0, size), before});
  }

  [[noreturn]] static void fail_foreign(std::string_view line, const DeckPlace& place) {
    if (trimmed(line).starts_with('*'))
      fail_at(place, "expected Radioss input, this is a deck of keywords with stars: name it .k or .inp");
    fail_at(place, fmt::format("expected a keyword such as /BEGIN, got \"{}\"", trimmed(line).substr(0, 40)));
  }

  void take_special(std::string_view& rest, DeckPlace& place) {
    const std::string_view line = first_line(rest);
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    ++place.line;
    if (line.starts_with('#')) return open_included(trimmed(line.substr(include.size())), place);
    RadiossBlock block;
    block.place = place;
    block.engine = in_engine_;
    read_header(line, block);
    if (block.name == "END/ENGINE") {  // the engine's input stands before that of the starter, in one file
      for (RadiossBlock& of_engine : deck_.blocks) of_engine.engine = true;
      return;
    }
    if (block.name == "END") {
      ended_ = true;
      return;
    }
    if (block.name.empty()) fail_at(place, "expected a keyword behind the slash");
    deck_.blocks.push_back(std::move(block));
  }

  void open_included(std::string_view name, const DeckPlace& place) {
    const fs::path given(name);
    const std::string path = (given.is_absolute() ? given : folder_ / given).lexically_normal().string();
    if (open_.size() > deepest_radioss_include || std::ranges::count(open_, path) != 0)
      fail_at(place, fmt::format("#include {}: the file includes itself", name));
    add_file(std::make_shared<const std::string>(files_.open(path, &place, "#include")), path);
  }

  /// /BEGIN says of which version the columns are.
  void require_version(const std::string& path) {
    const auto begin = std::ranges::find(deck_.blocks, "BEGIN", &RadiossBlock::name);
    if (begin == deck_.blocks.end()) {
      if (std::ranges::find(deck_.blocks, "RUN", &RadiossBlock::name) != deck_.blocks.end())
        throw InputError(path + ": expected the file of the starter, NAME_0000.rad, this is one of the engine");
      throw InputError(path + ": expected /BEGIN with the version of the input: forms before 5.1 are not read");
    }
    RadiossLines lines(*begin);
    const DataLine name = lines.require("the name of the run"), line = lines.require("the version of the input");
    const std::int64_t version = RadiossFields(line, *begin, version_line).integer("Invers");
    if (version < oldest_version)
      fail_at(line.place, fmt::format("/BEGIN: Invers: input of version {} is not read: expected at least {}, whose "
                                      "fields have ten and twenty columns",
                                      version, oldest_version));
    deck_.version = version;
  }

  RadiossDeck deck_;
  fs::path folder_;
  DeckFiles files_;
  std::vector<std::string> open_;
  bool in_engine_ = false, ended_ = false;
};

}  // namespace

std::string radioss_engine_of(const std::string& path, int run) {
  constexpr std::string_view of_starter = "_0000";
  const fs::path file(path);
  std::string name = file.stem().string();
  if (!name.ends_with(of_starter)) return "";
  name.back() = static_cast<char>('0' + run);
  const fs::path engine = file.parent_path() / (name + file.extension().string());
  std::error_code none;
  return fs::is_regular_file(engine, none) ? engine.string() : "";
}

RadiossDeck read_radioss_deck(const std::string& path) {
  RadiossReader reader(path);
  reader.read_starter(std::make_shared<const std::string>(bytes_of_file(path)), path);
  return reader.take();
}

RadiossDeck parse_radioss_deck(std::string text, const std::string& path) {
  RadiossReader reader(path);
  reader.read_starter(std::make_shared<const std::string>(std::move(text)), path);
  if (const std::string engine = radioss_engine_of(path); !engine.empty()) reader.read_engine(engine);
  return reader.take();
}

}  // namespace pinball
