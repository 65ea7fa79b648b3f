#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <solver/scene/schema/choices.hpp>
#include <solver/scene/schema/selection.hpp>
#include <solver/scene/schema/unset.hpp>

#include "entries.hpp"

/// Rows of a table, by the description of its keys.
namespace pinball {

template <schema::HasChoices Value>
std::string toml_text(Value value) {
  return toml_text(schema::name_of(value));
}
template <class Value>
std::string toml_text(const std::optional<Value>& value) {
  return toml_text(*value);
}
std::string toml_text(const ContactSide& side);
/// What is too long is counted, with a checksum that tells it from as many others.
std::string toml_text(const std::vector<std::int64_t>& numbers);
std::string toml_text(const std::vector<std::array<std::int64_t, 4>>& faces);
inline std::string toml_text(const std::optional<ElementSettings>&) { return "its own, below"; }

template <class T>
class KeyLister {
 public:
  /// without: what the object is where no key is given. Rows begin with `prefix`.
  KeyLister(Entries& table, const T& object, const T& without, std::string prefix = {})
      : table_(table), object_(object), without_(without), prefix_(std::move(prefix)) {}

  template <class Value>
  void operator()(const schema::FileKey<Value>&) const {}
  template <class Value>
  void operator()(const schema::Field<T, Value>&) const {}
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) const {
    const schema::About& about = key.about;
    if (about.done == schema::Done::by_hand || about.listed == schema::Listed::never) return;
    if (key.applies != nullptr && !key.applies(object_)) return;
    const Value& value = object_.*key.member;
    const bool unset = schema::is_unset(value, about), other = is_other(value, without_.*key.member, unset);
    if (!other && about.listed == schema::Listed::where_given) return;
    if constexpr (schema::InnerTable<Value>) {
      if (unset) {
        table_.add_words(prefix_ + key.name, about.otherwise, true);
      } else {
        list_part(key.name, value);
      }
    } else {
      const bool is_default = !other && about.need == schema::Need::optional && prefix_.empty();
      table_.add_words(prefix_ + key.name, unset ? about.otherwise : text_of(key, value), is_default, about.unit);
    }
  }
  /// Also what no file can have in this table, where a host has given it.
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) const {
    const KeyLister<Part> lister(table_, object_.*group.member, without_.*group.member);
    describe(schema::Of<Part>{}, [&](const auto& key) {
      if constexpr (requires { key.about; }) {
        if (key.about.listed != schema::Listed::where_given && schema::is_among(key.name, group.left_out)) return;
      }
      lister(key);
    });
  }

 private:
  template <class Value>
  static bool is_other(const Value& value, const Value& without, bool unset) {
    if constexpr (requires { value == without; }) {
      return !unset && !(value == without);
    } else {
      return !unset;
    }
  }
  template <class Value>
  static std::string text_of(const schema::AnyKey& key, const Value& value) {
    if constexpr (std::is_same_v<Value, bool>) {
      if (*key.about.yes) return toml_text(value ? key.about.yes : key.about.no);
    }
    return toml_text(value);
  }
  /// A table within this one.
  template <class Part>
  void list_part(const std::string& name, const Part& part) const {
    describe(schema::Of<Part>{}, KeyLister<Part>(table_, part, Part{}, prefix_ + name + '.'));
  }
  template <class Part>
  void list_part(const std::string& name, const std::optional<Part>& part) const {
    list_part(name, *part);
  }

  Entries& table_;
  const T& object_;
  const T& without_;
  std::string prefix_;
};

template <class T>
void list_keys(Entries& table, const T& object, const T& without = {}) {
  describe(schema::Of<T>{}, KeyLister<T>(table, object, without));
}

}  // namespace pinball
