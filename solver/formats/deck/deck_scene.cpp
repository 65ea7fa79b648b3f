#include "deck_scene.hpp"

#include <fmt/format.h>

namespace pinball {

GivenPlace DeckCard::given(std::string_view field) const {
  if (!place.file) return {};
  return GivenPlace(
      fmt::format("{}: {}{}", place.text(), keyword, field.empty() ? std::string() : fmt::format(" ({})", field)));
}

GivenValue given(bool value) { return GivenValue(value); }
GivenValue given(std::int64_t value) { return GivenValue(value); }
GivenValue given(double value) { return GivenValue(value); }
GivenValue given(std::string_view value) {
  std::string text;
  for (const char c : value) {
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) text += c;
  }
  return GivenValue(std::move(text));
}

void DeckScene::append(DeckScene&& more) {
  for (Part& part : more.parts_) parts_.push_back(std::move(part));
}

GivenTable DeckScene::take(std::string comment) {
  GivenTable scene = std::move(top_);
  scene.comment = std::move(comment);
  for (Part& part : parts_) {
    GivenTable* table = &scene;
    std::string_view name = part.name;
    if (const std::size_t dot = name.find('.'); dot != std::string_view::npos) {
      table = table->find(name.substr(0, dot))->as<GivenTable>();
      name.remove_prefix(dot + 1);
    }
    GivenValue value(std::move(part.table), part.place);
    if (!part.is_entry) {
      table->set(name, std::move(value), part.place);
      continue;
    }
    GivenValue* list = table->find(name);
    if (list == nullptr) list = &table->set(name, GivenValue(GivenArray{}, part.place), part.place);
    list->as<GivenArray>()->push_back(std::move(value));
  }
  return scene;
}

}  // namespace pinball
