#include "unread_fields.hpp"

#include <fmt/format.h>

#include <map>

#include "card_field.hpp"

namespace pinball {

void tell_unread_fields(const std::string& keyword, const DeckPlace& place, const ReadingLog::Left& left,
                        DeckReport& report) {
  std::map<std::string_view, std::vector<std::string>> names;  // by the remark
  for (std::size_t i = 0; i < 32; ++i) {
    if ((left.fields >> i & 1U) == 0) continue;
    const bool known = left.layout != nullptr && i < left.layout->size() && !(*left.layout)[i].name.empty();
    if (!known) {
      names[""].push_back(fmt::format("field {}", i + 1));
      continue;
    }
    const CardField& field = (*left.layout)[i];
    if (field.use == FieldUse::rejected) {
      report.reject(place, fmt::format("{} with {}", keyword, field.name), std::string(field.remark));
    } else {
      names[field.remark].emplace_back(field.name);
    }
  }
  for (const auto& [remark, fields] : names)
    report.unused(place, fmt::format("{}: {}", keyword, fmt::join(fields, ", ")), std::string(remark));
}

}  // namespace pinball
