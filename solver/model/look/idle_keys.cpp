#include "idle_keys.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <utility>

#include <solver/scene/schema/scene.hpp>
#include <solver/scene/schema/unset.hpp>
#include <solver/scene/without_keys.hpp>

namespace pinball {

namespace {

/// Keys that say nothing for one reason.
struct IdleKeys {
  std::string because;
  std::vector<std::string> keys;
};

/// Visits the keys of one table.
template <class T>
class IdleFinder {
 public:
  /// Names of keys begin with `prefix`.
  IdleFinder(const Scene& scene, const T& object, const T& without, std::vector<IdleKeys>& found, std::string prefix)
      : scene_(scene), object_(object), without_(without), found_(found), prefix_(std::move(prefix)) {}

  template <class Any>
  void operator()(const Any&) const {}
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) const {
    const Value& value = object_.*key.member;
    if (schema::is_unset(value, key.about) || !key.may_be_of(object_)) return;
    if constexpr (schema::InnerTable<Value>) look_into(key.name, value);
    if constexpr (requires { value == without_.*key.member; }) {
      if (value == without_.*key.member) return;
    }
    for (const schema::Idle<T>& idle : key.idle) {
      if (idle.holds == nullptr || !idle.holds(object_, scene_)) continue;
      add(idle.because, prefix_ + key.name);
      return;
    }
  }
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) const {
    visit_group(group, IdleFinder<Part>(scene_, object_.*group.member, without_.*group.member, found_, prefix_));
  }

 private:
  template <class Part>
  void look_into(const std::string& name, const Part& part) const {
    const Part without{};
    describe(schema::Of<Part>{}, IdleFinder<Part>(scene_, part, without, found_, prefix_ + name + '.'));
  }
  template <class Part>
  void look_into(const std::string& name, const std::optional<Part>& part) const {
    look_into(name, *part);
  }
  void add(const char* because, std::string key) const {
    for (IdleKeys& earlier : found_) {
      if (earlier.because == because) return earlier.keys.push_back(std::move(key));
    }
    found_.push_back({because, {std::move(key)}});
  }

  const Scene& scene_;
  const T& object_;
  const T& without_;
  std::vector<IdleKeys>& found_;
  std::string prefix_;
};

std::string sentence(const std::string& table, const IdleKeys& idle) {
  std::string keys;
  for (std::size_t k = 0; k < idle.keys.size(); ++k) {
    keys += k == 0 ? "" : k + 1 < idle.keys.size() ? ", " : " and ";
    keys += idle.keys[k];
  }
  return fmt::format("{}: {} {} not used {}", table, keys, idle.keys.size() == 1 ? "is" : "are", idle.because);
}

/// Visits the tables of a scene.
class IdleTables {
 public:
  explicit IdleTables(const Scene& scene) : scene_(scene) {}

  template <class Any>
  void operator()(const Any&) {}
  template <class Part>
  void operator()(const schema::Tables<Scene, Part>& tables) {
    look_at(tables.name, scene_.*tables.member);
  }
  template <class Part>
  void look_at(const std::string& name, const Part& part) {
    look_at(name, part, without_keys(part));
  }
  template <class Part>
  void look_at(const std::string& name, const std::vector<Part>& parts) {
    for (std::size_t p = 0; p < parts.size(); ++p) look_at(place_of(name, parts[p], p), parts[p]);
  }

  std::vector<std::string> found{};

 private:
  template <class Part>
  void look_at(const std::string& place, const Part& part, const Part& without) {
    std::vector<IdleKeys> idle;
    describe(schema::Of<Part>{}, IdleFinder<Part>(scene_, part, without, idle, ""));
    for (const IdleKeys& keys : idle) found.push_back(sentence(place, keys));
    if constexpr (std::is_same_v<Part, Body>) {
      if (part.element) look_at(place + ".element", *part.element, of_scene(part.element->hourglass));
    }
  }
  /// What a body without keys of elements has; where it chooses another form of hourglass control with the coefficient
  /// that follows from that.
  ElementSettings of_scene(HourglassControl hourglass) const {
    ElementSettings element = scene_.element;
    if (hourglass != element.hourglass) element.hourglass_coefficient = default_hourglass_coefficient(hourglass);
    return element;
  }
  /// As other messages name it.
  template <class Part>
  static std::string place_of(const std::string& name, const Part& part, std::size_t number) {
    if constexpr (requires { part.where; }) {
      if (!part.where.empty()) return part.where;
    }
    if constexpr (requires { part.nodes.where; }) {
      if (!part.nodes.where.empty()) return part.nodes.where;
    }
    if constexpr (requires { part.faces.where; }) {
      if (!part.faces.where.empty()) return part.faces.where;
    }
    if constexpr (requires { part.name; }) {
      if (!part.name.empty()) return fmt::format("{}.{}", name, part.name);
    }
    return fmt::format("{}.{}", name, number);
  }

  const Scene& scene_;
};

}  // namespace

std::vector<std::string> idle_keys(const Scene& scene) {
  IdleTables tables(scene);
  describe(schema::Of<Scene>{}, tables);
  tables.look_at("contact.pair", scene.contact_pairs);
  tables.look_at("contact.tied", scene.tied_contacts);
  return std::move(tables.found);
}

}  // namespace pinball
