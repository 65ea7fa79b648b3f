#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "bound.hpp"

namespace pinball {
struct Scene;
}

/// How a scene says what its tables hold: each key once, with all that is known of it. The files beside this one have a
/// function for each kind of table,
///
///     template <class Visit>
///     constexpr void describe(Of<TimeSettings>, Visit&& visit) {
///       visit(Key{"cfl", &TimeSettings::cfl, "fraction of the stable time step", {.unit = "-", .bound = ...}});
///
/// and what reads, checks, lists, binds or documents scenes visits the keys. A visitor is called with a Key, a FileKey,
/// a Group or a Field.
namespace pinball::schema {

/// In the place of an object of a type.
template <class T>
struct Of {};

/// A list of types.
template <class... T>
struct Types {};
template <class One, class List>
inline constexpr bool is_one_of = false;
template <class One, class... T>
inline constexpr bool is_one_of<One, Types<T...>> = (std::is_same_v<One, T> || ...);

/// A table within others, whose keys are listed and checked with theirs.
template <class Part>
struct IsInnerTable : std::false_type {};
template <class Part>
struct IsInnerTable<std::optional<Part>> : IsInnerTable<Part> {};
template <class Part>
concept InnerTable = IsInnerTable<Part>::value;

/// one_of: it or others in its place, which the function of the table sees to.
enum class Need { optional, required, one_of };

/// What is more to a value than its type.
enum class Form {
  plain,
  name,       ///< a text of letters, digits, "_" and "-"
  direction,  ///< a vector of any non-zero length, which is brought to unit length
  count,      ///< of elements: --refine multiplies it
};

/// Which numbers stand for none: a key that is not given leaves them.
enum class Unset { never, negative, zero, infinite, zero_or_infinite };

/// Who does it: the visitors for all keys, or the function of the table, whose rule is its own.
enum class Done { by_visitors, reading_by_hand, by_hand };

/// Where a scene as it is run is shown.
enum class Listed { always, where_given, never };

/// What is known of a key beside its name, its meaning and its place in memory.
struct About {
  const char* unit = "";  ///< of T, L and M, as in data/scenes/README.md: "L/T", "M/(L T^2)"; "-": a number without
  Bound bound{};          ///< of a number, of each of several; of integers low alone
  Need need = Need::optional;
  Form form = Form::plain;
  Unset unset = Unset::never;
  const char* otherwise = "";  ///< what holds where it is not given and no value says that; of a required one: when
  const char* field = "";      ///< its name in C++ and Python where that is another
  Done done = Done::by_visitors;
  Listed listed = Listed::always;
  std::span<const std::string_view> texts{};  ///< which texts it may have; none: any
  const char* also = "";                      ///< a text that may stand in the place of a number
  const char* no = "";                        ///< of a bool that has names in files: that of false
  const char* yes = "";                       ///< that of true
};

/// What all keys have in common.
struct AnyKey {
  const char* name;     ///< in files
  const char* meaning;  ///< a sentence, or the rest of one; code in backticks
  About about;

  constexpr AnyKey(const char* name_, const char* meaning_, About about_)
      : name(name_), meaning(meaning_), about(about_) {}
  constexpr bool required() const { return about.need == Need::required; }
};

/// A key that has no member of its own: a function of its table makes something of it. Value: what it is in a file.
template <class Value>
struct FileKey : AnyKey {
  constexpr FileKey(const char* name_, const char* meaning_, About about_ = {}) : AnyKey(name_, meaning_, about_) {}
};

/// Where a key that an object has says nothing, and what that is owed to: "where ..." or "without ...".
template <class T>
struct Idle {
  bool (*holds)(const T&, const Scene&) = nullptr;
  const char* because = "";
};

/// A key that sets a member.
template <class T, class Value>
struct Key : FileKey<Value> {
  Value T::*member;
  bool (*applies)(const T&) = nullptr;  ///< which objects have it; none: all
  const char* rejected = nullptr;       ///< where another object is read that has it; none: it may have it
  std::array<Idle<T>, 4> idle{};        ///< where it says nothing, which is told (model/look/idle_keys.hpp)

  constexpr Key(const char* name_, Value T::*member_, const char* meaning_, About about_ = {})
      : FileKey<Value>(name_, meaning_, about_), member(member_) {}
  /// The same key, of some objects only. What was read before says of which.
  constexpr Key only_where(bool (*applies_)(const T&), const char* rejected_ = nullptr) const {
    Key key = *this;
    key.applies = applies_;
    key.rejected = rejected_;
    return key;
  }
  /// The same key, which says nothing where this holds. Of a completed scene that the object is a part of.
  constexpr Key idle_where(bool (*holds)(const T&, const Scene&), const char* because) const {
    Key key = *this;
    std::size_t next = 0;
    while (*key.idle[next].because != '\0') ++next;  // with sanitizers GCC 12 knows no address of a function
    key.idle[next] = {holds, because};
    return key;
  }
  const char* field() const { return *this->about.field ? this->about.field : this->name; }
  /// Also where it is of no use, unless that is refused.
  bool may_be_of(const T& object) const { return rejected == nullptr || applies(object); }
};

/// A member whose own keys stand in the same table, but for some.
template <class T, class Part>
struct Group {
  const char* field;
  Part T::*member;
  const char* meaning;
  std::span<const std::string_view> left_out{};

  constexpr Group(const char* field_, Part T::*member_, const char* meaning_,
                  std::span<const std::string_view> left_out_ = {})
      : field(field_), member(member_), meaning(meaning_), left_out(left_out_) {}
};

/// A member that hosts see and no file sets.
template <class T, class Value>
struct Field {
  const char* field;
  Value T::*member;
  const char* meaning;

  constexpr Field(const char* field_, Value T::*member_, const char* meaning_)
      : field(field_), member(member_), meaning(meaning_) {}
};

/// What says which kind of table it is, where several may stand in its place.
template <class Visit>
constexpr void describe_type(Visit&& visit, const std::string_view& type) {
  visit(FileKey<std::string>{
      "type", "what it is", {.need = Need::required, .texts = std::span<const std::string_view>(&type, 1)}});
}

/// Whether a key is one of some.
template <class Names>
constexpr bool is_among(std::string_view name, const Names& names) {
  for (const std::string_view one : names) {
    if (one == name) return true;
  }
  return false;
}

/// The keys of a member, but for those that it leaves out.
template <class T, class Part, class Visit>
constexpr void visit_group(const Group<T, Part>& group, const Visit& visit) {
  describe(Of<Part>{}, [&](const auto& key) {
    if constexpr (requires { key.name; }) {
      if (is_among(key.name, group.left_out)) return;
    }
    visit(key);
  });
}

/// What is known of a key of a table, for what is read by hand.
template <class T>
constexpr About about(std::string_view name) {
  About found;
  describe(Of<T>{}, [&](const auto& key) {
    if constexpr (requires { key.about; }) {
      if (key.name == name) found = key.about;
    }
  });
  return found;
}

/// Finds a key by its name, also in the members whose keys stand in the same table.
struct KeyFinder {
  std::string_view name;
  bool* found;

  template <class Any>
  constexpr void operator()(const Any& key) const {
    if constexpr (requires { key.left_out; }) {
      visit_group(key, *this);
    } else if constexpr (requires { key.name; }) {
      if (key.name == name) *found = true;
    }
  }
};

/// Whether a table has a key of this name.
template <class T>
constexpr bool has_key(std::string_view name) {
  bool found = false;
  describe(Of<T>{}, KeyFinder{name, &found});
  return found;
}

/// Whether the keys of a part stand in the table of a whole.
template <class Part>
struct GroupFinder {
  bool* found;

  template <class Any>
  constexpr void operator()(const Any&) const {}
  template <class T>
  constexpr void operator()(const Group<T, Part>&) const {
    *found = true;
  }
};
template <class T, class Part>
constexpr bool has_group() {
  bool found = false;
  describe(Of<T>{}, GroupFinder<Part>{&found});
  return found;
}

/// The least that an integer may be.
constexpr std::int64_t lowest(const About& about) { return static_cast<std::int64_t>(about.bound.low); }

}  // namespace pinball::schema
