#include "given_archive.hpp"

#include <string>
#include <variant>

namespace pinball {

namespace {

void persist(StateArchive& archive, GivenValue& value);

void persist(StateArchive& archive, GivenPlace& place) {
  std::string text = place.text("");
  archive(text);
  if (archive.reads() && !text.empty()) place = GivenPlace(std::move(text));
}

/// How many there are, each of which takes a byte at the least.
template <class Items>
void persist_size(StateArchive& archive, Items& items) {
  std::uint64_t size = items.size();
  archive(size);
  archive.require(size <= archive.left());
  items.resize(size);
}

void persist(StateArchive& archive, GivenTable& table) {
  archive(table.comment);
  persist_size(archive, table.entries());
  for (GivenEntry& entry : table.entries()) {
    archive(entry.key);
    persist(archive, entry.place);
    persist(archive, entry.value);
  }
}

void persist(StateArchive& archive, GivenArray& array) {
  persist_size(archive, array);
  for (GivenValue& one : array) persist(archive, one);
}

void persist(StateArchive&, GivenDate&) {}

template <class Value>
void persist(StateArchive& archive,
             Value& value) requires(std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string>) {
  archive(value);
}

/// What a value of this kind is before it is read.
template <std::size_t kind = 0>
GivenValue::Any empty_of(std::size_t wanted) {
  if constexpr (kind + 1 < std::variant_size_v<GivenValue::Any>) {
    if (wanted != kind) return empty_of<kind + 1>(wanted);
  }
  return GivenValue::Any(std::in_place_index<kind>);
}

void persist(StateArchive& archive, GivenValue& value) {
  std::uint8_t kind = value.any.index();
  archive(kind);
  archive.require(kind < std::variant_size_v<GivenValue::Any>);
  if (archive.reads()) value.any = empty_of(kind);
  archive(value.is_inline);
  persist(archive, value.place);
  std::visit([&](auto& one) { persist(archive, one); }, value.any);
}

}  // namespace

void persist(StateArchive& archive, std::shared_ptr<const GivenScene>& given) {
  bool there = given != nullptr;
  archive(there);
  if (!there) return;
  if (archive.reads()) {
    auto read = std::make_shared<GivenScene>();
    archive(read->contact_said, read->file, read->options);
    persist(archive, read->table);
    given = std::move(read);
  } else {
    auto& written = const_cast<GivenScene&>(*given);  // an archive that measures or writes changes nothing
    archive(written.contact_said, written.file, written.options);
    persist(archive, written.table);
  }
}

}  // namespace pinball
