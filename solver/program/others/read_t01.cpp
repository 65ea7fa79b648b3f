#include "read_t01.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include <solver/base/error.hpp>

#include "history_rows.hpp"

/// A T01 file is records of Fortran: the length in bytes, so many bytes, and the length again; all numbers are
/// big-endian, of four bytes. In its head stand a code of the form and titles, six counts, and what is written of each
/// part, subset and group; then for each time a record with it, one of global quantities, and one each of parts,
/// subsets and groups.
namespace pinball {

namespace {

constexpr std::size_t word = 4, length_of_title = 80;
constexpr std::int64_t first_code = 3000, last_code = 9999;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < word; ++i) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Words of one record.
class Record {
 public:
  Record(const std::string& bytes, std::size_t begin, std::size_t length)
      : bytes_(&bytes), begin_(begin), words_(length / word) {}

  std::size_t words() const { return words_; }
  std::int64_t whole(std::size_t i) const { return std::bit_cast<std::int32_t>(at(i)); }
  double number(std::size_t i) const { return std::bit_cast<float>(at(i)); }

 private:
  std::uint32_t at(std::size_t i) const { return word_at(*bytes_, begin_ + i * word); }

  const std::string* bytes_;
  std::size_t begin_, words_;
};

class Records {
 public:
  Records(const std::string& bytes, const std::string& path) : bytes_(bytes), path_(path) {}

  /// The next one; nothing where the file ends in it.
  std::optional<Record> next() {
    if (bytes_.size() - at_ < 2 * word) return std::nullopt;
    const std::size_t length = word_at(bytes_, at_);
    if (length > bytes_.size() - at_ - 2 * word) return std::nullopt;
    if (word_at(bytes_, at_ + word + length) != length) fail("a record whose length stands at its end, too");
    const Record record(bytes_, at_ + word, length);
    at_ += length + 2 * word;
    return record;
  }
  Record require(std::size_t words, const char* what) {
    const std::optional<Record> record = next();
    if (!record || record->words() < words) fail(what);
    return *record;
  }
  std::size_t count(const Record& record, std::size_t i, const char* what) const {
    const std::int64_t count = record.whole(i);
    if (count < 0 || static_cast<std::size_t>(count) > bytes_.size()) fail(what);
    return count;
  }
  [[noreturn]] void fail(const char* what) const {
    throw InputError(fmt::format("{}: byte {}: expected {}", path_, at_, what));
  }

 private:
  const std::string& bytes_;
  const std::string& path_;
  std::size_t at_ = 0;
};

/// A group of /TH: what is written of each of its members, by numbers.
struct Group {
  std::int64_t type = 0;
  std::vector<std::int64_t> members, variables;
};

/// What each state has, in its order.
struct Head {
  std::vector<std::int64_t> global;
  std::size_t of_parts = 0, of_subsets = 0;  ///< numbers
  std::vector<Group> groups;
};

std::vector<std::int64_t> numbers_of(Records& records, std::size_t count, const char* what) {
  std::vector<std::int64_t> numbers;
  if (count == 0) return numbers;
  const Record record = records.require(count, what);
  for (std::size_t i = 0; i < count; ++i) numbers.push_back(record.whole(i));
  return numbers;
}

Group read_group(Records& records) {
  const Record line = records.require(5, "a group of histories");
  Group group;
  group.type = line.whole(1);
  const std::size_t members = records.count(line, 3, "how many members a group has"),
                    variables = records.count(line, 4, "how many quantities a group has");
  for (std::size_t i = 0; i < members; ++i) group.members.push_back(records.require(1, "a member of a group").whole(0));
  group.variables = numbers_of(records, variables, "the quantities of a group");
  return group;
}

Head read_head(Records& records) {
  constexpr std::int64_t code_of_units = 3050, code_of_title_80 = 3041, code_of_title_100 = 4021;
  const std::int64_t code = records.require(1, "a title").whole(0);
  const std::size_t title = (code >= code_of_title_100  ? 100
                             : code >= code_of_title_80 ? 80
                                                        : 40) /
                            word;  // of parts and what follows
  records.require(length_of_title / word, "a date");
  if (code > code_of_units) {
    for (const char* what : {"a number of records", "a length of titles", "units"}) records.require(1, what);
  }
  const Record counts = records.require(6, "six counts");
  const auto count = [&](std::size_t i) { return records.count(counts, i, "a count"); };
  const std::size_t parts = count(0), materials = count(1), properties = count(2), subsets = count(3),
                    groups = count(4);
  Head head;
  head.global = numbers_of(records, count(5), "global quantities");
  for (std::size_t i = 0; i < parts; ++i) {
    const Record line = records.require(title + 5, "a part");
    const std::size_t own = records.count(line, title + 4, "how many quantities a part has");
    numbers_of(records, own, "the quantities of a part");
    head.of_parts += own;
  }
  for (std::size_t i = 0; i < materials + properties; ++i) records.require(1, "a material or a property");
  for (std::size_t i = 0; i < subsets; ++i) {
    const Record line = records.require(5, "a subset");
    for (const std::size_t place : {2, 3, 4}) {
      const std::size_t own = records.count(line, place, "how many members a subset has");
      numbers_of(records, own, "the members of a subset");
      if (place == 4) head.of_subsets += own;
    }
  }
  for (std::size_t i = 0; i < groups; ++i) head.groups.push_back(read_group(records));
  return head;
}

/// Names of global quantities, as OpenRadioss' own program gives them; empty: none that is known.
const char* name_of_global(std::int64_t code) {
  switch (code) {
    case 1:
      return "INTERNAL ENERGY";
    case 2:
      return "KINETIC ENERGY";
    case 3:
      return "X-MOMENTUM";
    case 4:
      return "Y-MOMENTUM";
    case 5:
      return "Z-MOMENTUM";
    case 7:
      return "TIME STEP";
    case 9:
      return "EXTERNAL WORK";
    case 11:
      return "CONTACT ENERGY";
    case 12:
      return "HOURGLASS ENERGY";
    default:
      return "";
  }
}

void set_global(const Head& head, const Record& state, Rows& rows) {
  constexpr std::int64_t kinetic = 2, of_rotations = 8;
  double rotations = 0;
  for (std::size_t i = 0; i < head.global.size(); ++i)
    rotations += head.global[i] == of_rotations ? state.number(i) : 0.0;
  for (std::size_t i = 0; i < head.global.size(); ++i) {
    const std::string name = name_of_global(head.global[i]);
    if (!name.empty())
      rows.set(name, state.number(i) + (head.global[i] == kinetic ? rotations : 0.0), meaning_of_column);
  }
}

void set_nodes(const Group& group, const Record& state, Rows& rows) {
  constexpr std::int64_t nodes = 0, first_displacement = 1, last_velocity = 6;
  if (group.type != nodes) return;
  for (std::size_t m = 0; m < group.members.size(); ++m) {
    for (std::size_t v = 0; v < group.variables.size(); ++v) {
      const std::int64_t code = group.variables[v] - first_displacement;
      if (code < 0 || code >= last_velocity) continue;
      const std::string column =
          fmt::format("node_{}_{}_{}", group.members[m], code < 3 ? "displacement" : "velocity", "xyz"[code % 3]);
      rows.set(column, state.number(m * group.variables.size() + v), meaning_of_column);
    }
  }
}

/// One record each, of what there is.
struct State {
  std::optional<Record> time, global;
  std::vector<std::optional<Record>> groups;
};

/// Nothing: the file ends in it.
std::optional<State> next_state(Records& records, const Head& head) {
  State state;
  const auto take = [&](std::size_t words) {
    const std::optional<Record> record = records.next();
    if (record && record->words() < words) records.fail("a longer record of a state");
    return record;
  };
  if (!(state.time = take(1))) return std::nullopt;
  if (!head.global.empty() && !(state.global = take(head.global.size()))) return std::nullopt;
  if (head.of_parts > 0 && !take(head.of_parts)) return std::nullopt;
  if (head.of_subsets > 0 && !take(head.of_subsets)) return std::nullopt;
  for (const Group& group : head.groups) {
    state.groups.push_back(take(group.members.size() * group.variables.size()));
    if (!state.groups.back()) return std::nullopt;
  }
  return state;
}

}  // namespace

bool is_t01(const std::string& bytes) {
  constexpr std::size_t first = word + length_of_title;
  if (bytes.size() < first + 2 * word || word_at(bytes, 0) != first || word_at(bytes, word + first) != first)
    return false;
  const std::int64_t code = word_at(bytes, word);
  return code >= first_code && code <= last_code;
}

void read_t01(const std::string& bytes, OtherHistory& history) {
  history.kind = "T01 of Radioss";
  Records records(bytes, history.path);
  const Head head = read_head(records);
  Rows rows(history);
  while (const std::optional<State> state = next_state(records, head)) {
    const double time = state->time->number(0);
    if (!std::isfinite(time)) records.fail("finite times");
    rows.begin(time);
    if (state->global) set_global(head, *state->global, rows);
    for (std::size_t g = 0; g < head.groups.size(); ++g) set_nodes(head.groups[g], *state->groups[g], rows);
  }
}

}  // namespace pinball
