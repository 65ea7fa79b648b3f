#include "read_binout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <solver/base/error.hpp>

#include "history_rows.hpp"

/// LSDA (LSTC I/O library) is a header of eight bytes and records: a length in bytes, of all of the record, a command
/// and what belongs to it. Commands that matter are one that goes to a folder, absolute or from the present one, and
/// one that puts an array of numbers of one type under a name there. The header says how many bytes lengths, commands
/// and types have, and which end of a number comes first. States of a history lie in folders such as /glstat/d000001.
namespace pinball {

namespace {

constexpr std::size_t size_of_header = 8;
constexpr std::uint64_t go_to_folder = 2, put_array = 3;

/// Bytes of a number of a type; 0: not one of numbers.
std::size_t size_of_type(std::uint64_t type) {
  static constexpr std::size_t sizes[]{0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8};
  return type < std::size(sizes) ? sizes[type] : 0;
}

/// Where `given` leads from `folder`: "../d000002" from "/nodout/d000001".
std::string path_from(const std::string& folder, std::string_view given) {
  std::string path = given.starts_with('/') ? "" : folder;
  for (std::size_t at = 0; at <= given.size();) {
    const std::size_t end = std::min(given.find('/', at), given.size());
    const std::string_view word = given.substr(at, end - at);
    if (word == "..") {
      path.resize(path.empty() ? 0 : path.rfind('/'));
    } else if (!word.empty() && word != ".") {
      path += '/';
      path += word;
    }
    at = end + 1;
  }
  return path;
}

using Arrays = std::map<std::string, std::vector<double>>;
using States = std::map<double, std::map<std::string, double>>;  ///< by their times

class BinoutReader {
 public:
  BinoutReader(const std::string& bytes, const std::string& path)
      : bytes_(bytes), path_(path), big_(bytes[5] == 0), length_(bytes[1]), command_(bytes[3]), type_(bytes[4]) {}

  States read() {
    for (std::size_t at = size_of_header; bytes_.size() - at >= length_ + command_;) {
      const std::uint64_t length = whole(at, length_);
      if (length < length_ + command_)
        throw InputError(fmt::format("{}: byte {}: expected the length of a record, got {}", path_, at, length));
      if (length > bytes_.size() - at) break;  // still being written
      take(whole(at + length_, command_), at + length_ + command_, at + length);
      at += length;
    }
    end_folder();
    return std::move(states_);
  }

 private:
  std::uint64_t whole(std::size_t at, std::size_t size) const {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8U | static_cast<unsigned char>(bytes_[big_ ? at + i : at + size - 1 - i]);
    return value;
  }
  double number(std::uint64_t type, std::size_t at) const {
    constexpr std::uint64_t single = 9, of_two = 10;
    if (type == single) return std::bit_cast<float>(static_cast<std::uint32_t>(whole(at, 4)));
    if (type == of_two) return std::bit_cast<double>(whole(at, 8));
    return static_cast<double>(whole(at, size_of_type(type)));
  }

  void take(std::uint64_t command, std::size_t begin, std::size_t end) {
    if (command == go_to_folder) {
      end_folder();
      folder_ = path_from(folder_, std::string_view(bytes_).substr(begin, end - begin));
      is_of_history_ = folder_.starts_with("/glstat/") || folder_.starts_with("/nodout/");
    }
    if (command != put_array || !is_of_history_ || end - begin <= type_) return;
    const std::uint64_t type = whole(begin, type_);
    const std::size_t size = size_of_type(type), of_name = whole(begin + type_, 1), data = begin + type_ + 1 + of_name;
    if (size == 0 || data > end) return;
    std::vector<double>& array = arrays_[bytes_.substr(begin + type_ + 1, of_name)];
    array.clear();
    for (std::size_t at = data; at + size <= end; at += size) array.push_back(number(type, at));
  }

  /// What its arrays say.
  void end_folder() {
    const Arrays arrays = std::exchange(arrays_, {});
    if (const auto ids = arrays.find("ids"); ids != arrays.end() && folder_.starts_with("/nodout/"))
      nodes_ = ids->second;
    const auto time = arrays.find("time");
    if (time == arrays.end() || time->second.size() != 1) return;
    if (!std::isfinite(time->second[0])) throw InputError(fmt::format("{}: {}: expected finite times", path_, folder_));
    std::map<std::string, double>& state = states_[time->second[0]];
    if (folder_.starts_with("/glstat/")) {
      for (const auto& [name, values] : arrays) {
        if (name != "time" && values.size() == 1) state[name] = values[0];
      }
      return;
    }
    for (const char* quantity : {"displacement", "velocity"}) {
      for (const char axis : {'x', 'y', 'z'}) {
        const auto values = arrays.find(fmt::format("{}_{}", axis, quantity));
        if (values == arrays.end() || values->second.size() != nodes_.size()) continue;
        for (std::size_t i = 0; i < nodes_.size(); ++i)
          state[fmt::format("node_{:.0f}_{}_{}", nodes_[i], quantity, axis)] = values->second[i];
      }
    }
  }

  const std::string& bytes_;
  const std::string& path_;
  bool big_;
  std::size_t length_, command_, type_;  ///< bytes
  std::string folder_;
  bool is_of_history_ = false;
  Arrays arrays_;  ///< of the folder
  std::vector<double> nodes_;
  States states_;
};

}  // namespace

bool is_binout(const std::string& bytes) {
  if (bytes.size() < size_of_header || bytes[0] != size_of_header || bytes[6] != 0) return false;
  for (const std::size_t place : {1, 2, 3, 4}) {
    if (bytes[place] < 1 || bytes[place] > 8) return false;
  }
  return bytes[5] == 0 || bytes[5] == 1;
}

void read_binout(const std::string& bytes, OtherHistory& history) {
  history.kind = "binout of LS-DYNA";
  Rows rows(history);
  for (const auto& [time, state] : BinoutReader(bytes, history.path).read()) {
    rows.begin(time);
    for (const auto& [name, value] : state) {
      rows.set(name, value, [](const std::string& own) {
        return own.starts_with("node_") ? meaning_of_column(own) : meaning_in_glstat(own);
      });
    }
  }
}

}  // namespace pinball
