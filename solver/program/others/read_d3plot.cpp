#include "read_d3plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/formats/deck/number_text.hpp>

/// A d3plot ("LS-DYNA Database Binary Output Files") is an array of words of four or eight bytes: a head, which says
/// how much there is of everything, the mesh, the numbers that nodes, elements and parts have in the deck, titles, and
/// states of equal size. The files that go on with it hold nothing but states. A word of -999999 ends what a file
/// holds, or a part of it; zeros fill up its last block.
namespace pinball {

namespace {

namespace d3plot {

/// Words of the head, by what they say; 64 and later ones are there where more_head says so.
enum Word : std::size_t {
  file_type = 11,
  dimensions = 15,
  nodes = 16,
  code = 17,
  globals = 18,
  temperatures = 19,
  has_places = 20,
  has_velocities = 21,
  has_accelerations = 22,
  solids = 23,
  numbers_of_solid = 27,
  beams = 28,
  numbers_of_beam = 30,
  shells = 31,
  numbers_of_shell = 33,
  layers = 36,
  particles = 37,
  words_of_numbering = 39,
  thick_shells = 40,
  numbers_of_thick_shell = 42,
  fluid_materials = 47,
  adapted = 50,
  airbags = 54,
  shells_of_eight_nodes = 55,
  more_of_nodes = 56,
  more_head = 57,
  size_of_head = 64,
  thermal_numbers_of_solid = 65
};
constexpr std::array<std::size_t, 7> elements_of_more_nodes{64, 66, 68, 69, 71, 72, 73};
constexpr std::array<std::size_t, 2> contact_of_nodes{78, 79};
/// Files with places of nodes over time: d3plot and d3part; with 1000 more where numbers of the deck have 64 bits.
constexpr std::array<std::int64_t, 2> types{1, 5};
constexpr std::int64_t of_long_numbers = 1000;
constexpr std::int64_t dyna = 6;  ///< the code that has written it

constexpr double end_mark = -999999;
constexpr std::size_t bytes_of_title = 72, bytes_of_keyword = 80;  ///< whatever the size of a word

}  // namespace d3plot

/// How words are written.
struct D3plotWords {
  std::size_t size = 4;
  bool big = false;  ///< the highest byte comes first

  std::uint64_t bits(const std::string& bytes, std::size_t at) const {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8U | static_cast<unsigned char>(bytes[at + (big ? i : size - 1 - i)]);
    return value;
  }
  /// at: first byte of the word.
  std::int64_t whole(const std::string& bytes, std::size_t at) const {
    const std::uint64_t value = bits(bytes, at);
    return size == 4 ? static_cast<std::int32_t>(static_cast<std::uint32_t>(value)) : static_cast<std::int64_t>(value);
  }
  double number(const std::string& bytes, std::size_t at) const {
    const std::uint64_t value = bits(bytes, at);
    return size == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(value)) : std::bit_cast<double>(value);
  }

  bool can_be(const std::string& bytes) const {
    if (bytes.size() < d3plot::size_of_head * size) return false;
    const auto head = [&](d3plot::Word word) { return whole(bytes, word * size); };
    return std::ranges::count(d3plot::types, head(d3plot::file_type) % d3plot::of_long_numbers) == 1 &&
           head(d3plot::code) == d3plot::dyna && head(d3plot::dimensions) >= 2 && head(d3plot::dimensions) <= 9 &&
           head(d3plot::nodes) > 0;
  }
};

/// The forms in which bytes may be the beginning of a d3plot: one, or none.
std::vector<D3plotWords> forms_of(const std::string& bytes) {
  std::vector<D3plotWords> forms;
  for (const std::size_t size : {4, 8}) {
    for (const bool big : {false, true}) {
      if (const D3plotWords words{size, big}; words.can_be(bytes)) forms.push_back(words);
    }
  }
  return forms;
}

/// Where a state lies.
struct Place {
  double time;
  std::string path;
  std::size_t at;  ///< first byte
};

class D3plotReader {
 public:
  D3plotReader(const std::string& bytes, OtherHistory& history)
      : bytes_(bytes), history_(history), words_(forms_of(bytes).front()) {}

  void read() {
    take_head();
    take_mesh();
    find_states(history_.path, bytes_.size(), after_titles());
    for (const auto& [number, path] : others_of_family()) find_states(path, std::filesystem::file_size(path), 0);
    make_curves();
  }

 private:
  /// NAME01 ... NAME99, NAME100 and so on beside NAME, by their numbers.
  std::map<std::int64_t, std::string> others_of_family() const {
    std::map<std::int64_t, std::string> others;
    const std::filesystem::path first(history_.path);
    const std::string name = first.filename();
    const std::filesystem::path folder = first.has_parent_path() ? first.parent_path() : ".";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string other = entry.path().filename();
      if (other.size() < name.size() + 2 || !other.starts_with(name)) continue;
      if (const auto number = deck_integer(other.substr(name.size())); number && *number > 0)
        others.emplace(*number, entry.path());
    }
    return others;
  }

  /// Of the longer head; 0 where there is none.
  std::size_t head_word(std::size_t word) const {
    return word < d3plot::size_of_head + head(d3plot::more_head) ? head(word) : 0;
  }
  /// A count, which may be written with a sign that says something else.
  std::size_t head(std::size_t word) const { return count(word, true); }
  /// No count is larger than the file, but for what is of no use.
  std::size_t count(std::size_t word, bool of_either_sign = false) const {
    const std::int64_t value = words_.whole(bytes_, word * words_.size);
    const std::uint64_t size = value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
    if (size > bytes_.size() || (value < 0 && !of_either_sign)) {
      throw InputError(fmt::format("{}: byte {}: expected a count, got {}", history_.path, word * words_.size, value));
    }
    return size;
  }
  std::int64_t signed_head(std::size_t word) const { return words_.whole(bytes_, word * words_.size); }
  /// Of flags, each of a digit.
  std::int64_t digit_of(d3plot::Word word, std::int64_t unit) const { return signed_head(word) / unit % 10; }

  [[noreturn]] void not_read(std::string_view what) const {
    throw InputError(fmt::format("{}: a d3plot with {} is not read", history_.path, what));
  }

  void take_head() {
    const std::size_t size = d3plot::size_of_head + head(d3plot::more_head);
    require(size);
    if (signed_head(d3plot::file_type) > d3plot::of_long_numbers) not_read("numbers of 64 bits");
    if (head(d3plot::dimensions) == 2) not_read("two dimensions");
    if (head(d3plot::dimensions) > 5) not_read("road surfaces or motions of rigid bodies");
    if (head(d3plot::particles) > 0) not_read("particles (SPH)");
    if (head(d3plot::airbags) > 0) not_read("airbag particles");
    if (signed_head(d3plot::solids) < 0) not_read("solids of ten nodes");
    const auto given = [this](std::size_t word) { return head_word(word) != 0; };
    if (head(d3plot::shells_of_eight_nodes) > 0 || std::ranges::any_of(d3plot::elements_of_more_nodes, given))
      not_read("elements of higher order");
    if (std::ranges::any_of(d3plot::contact_of_nodes, given)) not_read("penetrations or contact energies of nodes");
    next_ = size;
    if (head(d3plot::dimensions) == 5) {  // which parts are rigid: shells of these have no numbers
      require(next_ + 2);
      rigid_shells_ = count(next_);
      next_ += 2 + count(next_ + 1);
    }
    next_ += head(d3plot::fluid_materials);
  }

  double number(std::size_t word) const { return words_.number(bytes_, word * words_.size); }
  /// That so many words are there.
  void require(std::size_t words) const {
    if (words <= bytes_.size() / words_.size) return;
    throw InputError(fmt::format("{}: byte {}: expected {} words of {} bytes, got the end of the file", history_.path,
                                 bytes_.size(), words, words_.size));
  }

  /// Places of the nodes at the start, and their numbers in the deck.
  void take_mesh() {
    const std::size_t count = head(d3plot::nodes), mesh = 3 * count + 9 * head(d3plot::solids) +
                                                          9 * head(d3plot::thick_shells) + 6 * head(d3plot::beams) +
                                                          5 * head(d3plot::shells);
    require(next_ + mesh + head(d3plot::words_of_numbering) + 2 * head(d3plot::adapted));
    first_places_ = next_;
    next_ += mesh;
    if (head(d3plot::words_of_numbering) > 0) {
      constexpr std::size_t own_words = 10, with_parts = 16, counted = 5;
      const auto numbering = [&](std::size_t word) { return words_.whole(bytes_, (next_ + word) * words_.size); };
      const std::size_t begin = numbering(0) < 0 ? with_parts : own_words;
      if (head(d3plot::words_of_numbering) < begin + count || std::cmp_not_equal(numbering(counted), count)) {
        throw InputError(fmt::format("{}: byte {}: expected the numbers of {} nodes, got {} words of others",
                                     history_.path, next_ * words_.size, count, head(d3plot::words_of_numbering)));
      }
      for (std::size_t n = 0; n < count; ++n) numbers_.push_back(numbering(begin + n));
    } else {
      numbers_.resize(count);
      std::iota(numbers_.begin(), numbers_.end(), 1);
    }
    next_ += head(d3plot::words_of_numbering) + 2 * head(d3plot::adapted);
  }

  /// The first byte behind titles of the run, of parts and of contacts, and of what was in the deck.
  std::size_t after_titles() const {
    const std::size_t size = words_.size;
    std::size_t at = next_ * size;
    const auto is_there = [&](std::size_t bytes) { return at + bytes <= bytes_.size(); };
    const auto skip_mark = [&] {
      if (is_there(size) && words_.number(bytes_, at) == d3plot::end_mark) at += size;
    };
    skip_mark();
    while (is_there(2 * size)) {
      const std::int64_t kind = words_.whole(bytes_, at);
      const std::int64_t count = std::clamp<std::int64_t>(words_.whole(bytes_, at + size), 0, std::ssize(bytes_));
      if (kind == 90000) {
        at += size + d3plot::bytes_of_title;
      } else if (kind == 90001 || kind == 90002 || kind == 90020) {
        at += 2 * size + count * (size + d3plot::bytes_of_title);
      } else if (kind == 900100 || kind == 90100) {
        at += 2 * size + count * d3plot::bytes_of_keyword;
      } else {
        break;
      }
      skip_mark();
    }
    return at;
  }

  /// Numbers of a node before its velocity, and all of it.
  std::pair<std::size_t, std::size_t> numbers_of_node() const {
    const std::int64_t heat = digit_of(d3plot::temperatures, 1);
    std::size_t before = head(d3plot::has_places) != 0 ? 3 : 0;
    if (heat > 0) before += heat == 1 ? 1 : heat == 2 ? 4 : 6;
    if (digit_of(d3plot::temperatures, 10) == 1) ++before;      // mass that was added
    if (digit_of(d3plot::more_of_nodes, 1) == 1) ++before;      // rate of temperature
    if (digit_of(d3plot::more_of_nodes, 10) == 1) before += 6;  // forces and moments that are left
    return {before,
            before + (head(d3plot::has_velocities) != 0 ? 3 : 0) + (head(d3plot::has_accelerations) != 0 ? 3 : 0)};
  }
  std::size_t words_of_state() const {
    constexpr std::int64_t of_elements = -10000;
    std::size_t deleted = 0;
    if (signed_head(d3plot::layers) <= of_elements) {
      deleted = head(d3plot::solids) + head(d3plot::thick_shells) + head(d3plot::beams) + head(d3plot::shells);
    } else if (signed_head(d3plot::layers) < 0) {
      deleted = head(d3plot::nodes);
    }
    return 1 + head(d3plot::globals) + head(d3plot::nodes) * numbers_of_node().second +
           head(d3plot::solids) * (head(d3plot::numbers_of_solid) + head_word(d3plot::thermal_numbers_of_solid)) +
           head(d3plot::thick_shells) * head(d3plot::numbers_of_thick_shell) +
           head(d3plot::beams) * head(d3plot::numbers_of_beam) +
           (head(d3plot::shells) - std::min(rigid_shells_, head(d3plot::shells))) * head(d3plot::numbers_of_shell) +
           deleted;
  }

  /// bytes: of the file.
  void find_states(const std::string& path, std::size_t bytes, std::size_t at) {
    const std::size_t size = words_of_state() * words_.size;
    std::ifstream file(path, std::ios::binary);
    for (; at + size <= bytes; at += size) {
      const double time = words_.number(part_of(file, path, at, words_.size), 0);
      if (time == d3plot::end_mark) return;
      if (time == 0) {  // or what fills up a block
        const std::string state = part_of(file, path, at, size);
        if (std::ranges::count(state, '\0') == std::ssize(state)) return;
      }
      if (!std::isfinite(time))
        throw InputError(fmt::format("{}: byte {}: expected the time of a state, got {}", path, at, time));
      while (!states_.empty() && states_.back().time >= time) states_.pop_back();  // taken up again
      states_.push_back({time, path, at});
    }
  }
  static std::string part_of(std::ifstream& file, const std::string& path, std::size_t at, std::size_t bytes) {
    std::string part(bytes, '\0');
    file.seekg(at);
    if (!file.read(part.data(), std::ssize(part)))
      throw InputError(fmt::format("{}: byte {}: cannot be read", path, at));
    return part;
  }

  void make_curves() {
    const std::size_t every = std::max<std::size_t>(1, std::ceil(6.0 * states_.size() * numbers_.size() / most_kept));
    history_.kind = "d3plot of LS-DYNA";
    if (every > 1) history_.kind += fmt::format(", one of {} states", every);
    std::vector<Place> kept;
    for (std::size_t s = 0; s < states_.size(); ++s) {
      if (s % every == 0 || s + 1 == states_.size()) kept.push_back(states_[s]);
    }
    for (const Place& state : kept) history_.times.push_back(state.time);
    add_curves();
    for (const Place& state : kept) take(state);
  }

  /// Those of the whole, in the order in which states have them, and then those of nodes. The total is the sum of the
  /// two before it, without what contact, hourglass forces and erosion have.
  void add_curves() {
    constexpr std::array<const char*, 6> of_all{"kinetic energy",    "internal energy",   "kinetic and internal energy",
                                                "global x velocity", "global y velocity", "global z velocity"};
    const auto add = [this](std::string name, Meaning meaning) {
      history_.curves.push_back({std::move(name), std::move(meaning)});
      history_.curves.back().values.reserve(history_.times.size());
    };
    globals_ = head(d3plot::globals) < of_all.size() ? 0 : of_all.size();  // of a thermal run they are others
    for (std::size_t k = 0; k < globals_; ++k) add(of_all[k], meaning_in_glstat(of_all[k]));
    for (const auto& [there, quantity] :
         {std::pair{d3plot::has_places, "displacement"}, {d3plot::has_velocities, "velocity"}}) {
      if (head(there) == 0) continue;
      for (const std::int64_t node : numbers_) {
        for (const char axis : {'x', 'y', 'z'}) {
          const std::string name = fmt::format("node_{}_{}_{}", node, quantity, axis);
          add(name, meaning_of_column(name));
        }
      }
    }
  }

  void take(const Place& state) {
    std::ifstream file(state.path, std::ios::binary);
    const std::size_t count = numbers_.size(), before = 1 + head(d3plot::globals);
    const auto [velocity, all] = numbers_of_node();
    const std::string bytes = part_of(file, state.path, state.at, (before + count * all) * words_.size);
    const auto value = [&](std::size_t word) { return words_.number(bytes, word * words_.size); };
    auto curve = history_.curves.begin();
    for (std::size_t k = 0; k < globals_; ++k) (curve++)->values.push_back(value(1 + k));
    if (head(d3plot::has_places) != 0) {
      for (std::size_t i = 0; i < 3 * count; ++i)
        (curve++)->values.push_back(value(before + i) - number(first_places_ + i));
    }
    if (head(d3plot::has_velocities) == 0) return;
    for (std::size_t i = 0; i < 3 * count; ++i) (curve++)->values.push_back(value(before + velocity * count + i));
  }

  const std::string& bytes_;
  OtherHistory& history_;
  D3plotWords words_;
  std::size_t next_ = 0;          ///< the first word that was not looked at
  std::size_t first_places_ = 0;  ///< word at which the places of nodes at the start begin
  std::size_t rigid_shells_ = 0;
  std::size_t globals_ = 0;            ///< numbers of the whole that are known
  std::vector<std::int64_t> numbers_;  ///< of the nodes, in the deck
  std::vector<Place> states_;
};

}  // namespace

bool is_d3plot(const std::string& bytes) { return !forms_of(bytes).empty(); }

void read_d3plot(const std::string& bytes, OtherHistory& history) { D3plotReader(bytes, history).read(); }

}  // namespace pinball
