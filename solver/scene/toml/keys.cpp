#include <solver/scene/schema/kinds.hpp>

#include "table.hpp"

namespace pinball::schema {

namespace {

/// The names of the keys of a table. some: of which object; none: of all.
template <class T>
class KeyNames {
 public:
  KeyNames(std::vector<std::string_view>& names, const T* some) : names_(names), some_(some) {}

  template <class Value>
  void operator()(const FileKey<Value>& key) const {
    add(key.name);
  }
  template <class Value>
  void operator()(const Key<T, Value>& key) const {
    if (some_ == nullptr || key.applies == nullptr || key.applies(*some_)) add(key.name);
  }
  template <class Part>
  void operator()(const Group<T, Part>& group) const {
    visit_group(group, KeyNames<Part>(names_, nullptr));
  }
  template <class Value>
  void operator()(const Field<T, Value>&) const {}
  template <class Part>
  void operator()(const Tables<T, Part>& tables) const {
    add(tables.name);
  }

 private:
  void add(std::string_view name) const {
    if (!is_among(name, names_)) names_.push_back(name);
  }

  std::vector<std::string_view>& names_;
  const T* some_;
};

template <class T>
TableKeys keys(const Kind& kind, const T* some = nullptr) {
  TableKeys table{kind.name, kind.shown, {}};
  describe(Of<T>{}, KeyNames<T>(table.keys, some));
  return table;
}
template <class... T>
std::vector<TableKeys> keys_of() {
  return {keys<T>(kind(Of<T>{}))...};
}
template <class... T>
std::vector<TableKeys> keys_of_all(Types<T...> /*tables*/) {
  return keys_of<T...>();
}

/// A table that may be of several kinds, of which a key says which: all keys.
TableKeys together(std::string_view name, const std::vector<TableKeys>& kinds) {
  TableKeys table{name, kinds.front().shown, {}};
  for (const TableKeys& one : kinds) {
    for (const std::string_view key : one.keys) {
      if (!is_among(key, table.keys)) table.keys.push_back(key);
    }
  }
  return table;
}

std::vector<TableKeys> mesh_keys() {
  std::vector<TableKeys> kinds = keys_of<BlockMesh, RoundNosedRodMesh, CylinderMesh, SphereMesh>(), by_ending;
  for (const auto& format : choices(Of<MeshFormat>{})) {
    FileMesh mesh;
    mesh.format = format.value;
    kinds.push_back(keys({format.name, kinds.front().shown.data()}, &mesh));
    if (format.value != MeshFormat::gmsh) by_ending.push_back(kinds.back());
  }
  kinds.push_back(together("file", by_ending));
  kinds.insert(kinds.begin(), together("mesh", kinds));
  return kinds;
}

/// In the order in which the nearest key is looked for.
std::vector<TableKeys> all_kinds() {
  std::vector<TableKeys> all = keys_of<Scene, TimeSettings, ElementSettings>();
  const auto add = [&all](const std::vector<TableKeys>& more) { all.insert(all.end(), more.begin(), more.end()); };
  add({keys<ElementSettings>(element_of_body)});
  add(keys_of<ContactSettings, ContactPair, TiedContact, SideOfSet, SkipSettings, GuardSettings, OutputSettings,
              Material, OneYieldCurve, YieldCurve>());
  add(keys_of_all(TablesOfMaterial{}));
  add(keys_of<Body>());
  add(mesh_keys());
  add(keys_of<RigidBody, AttachedNodes, RigidMotion, Joint>());
  add({together("constraint", keys_of<PlaneConstraint, FixedConstraint>())});
  add(keys_of<PlaneConstraint, FixedConstraint, EquationTerm, Plane, Line, Box, RigidWall, PrescribedVelocity,
              NodalLoad, Pressure, Gravity, PointMass, InitialVelocity, InitialStress, DampingSettings, Probe>());
  return all;
}

const std::vector<TableKeys>& kinds() {
  static const std::vector<TableKeys> all = all_kinds();
  return all;
}

}  // namespace

}  // namespace pinball::schema

namespace pinball {

const std::vector<TableKeys>& scene_keys() { return schema::kinds(); }

}  // namespace pinball
