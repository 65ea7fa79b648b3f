#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <solver/formats/deck/line_fields.hpp>

/// The smallest parts of Abaqus input: names, labels, data lines.
namespace pinball {

/// Upper case without blanks: keywords, parameters and what they may be have neither case nor blanks.
std::string squeezed(std::string_view text);

/// A label by which sets and the like are found: in upper case, but for what stands in quotes, and without these.
std::string label_key(std::string_view label);
/// The same for people: as it is written, without the quotes.
std::string label_text(std::string_view label);

/// Gives things that have different keys different names: where two labels are written alike but for quotes, their
/// keys. keys: one per item.
template <class Items, class Name>
void tell_apart(Items& items, const std::vector<std::string>& keys, Name name) {
  std::map<std::string, std::string> key_of_name;
  std::set<std::string> shared;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto [found, is_new] = key_of_name.try_emplace(items[i].*name, keys[i]);
    if (!is_new && found->second != keys[i]) shared.insert(found->first);
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (shared.contains(items[i].*name)) items[i].*name = keys[i];
  }
}

/// "INSTANCE.NAME" cut at the first point outside of quotes; none: there is no point.
std::optional<std::pair<std::string, std::string>> split_label(std::string_view label);

/// What stands between the commas of a line, however many; a comma at its end ends nothing.
std::vector<std::string_view> entries_of(std::string_view line);

/// Whether a line goes on in the next one: it ends in a comma.
bool goes_on(std::string_view line);

/// The fields of a data line by their places, which follow one another between commas; a line without a comma is one
/// field, however long.
class DataFields final : public LineFields {
 public:
  explicit DataFields(const DataLine& line) : LineFields(line) {
    if (!cut_at_commas(line.text) && !line.text.empty()) add(line.text);
  }
  ~DataFields();
  DataFields(const DataFields&) = delete;
  DataFields& operator=(const DataFields&) = delete;
};

}  // namespace pinball
