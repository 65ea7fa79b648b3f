#include <solver/scene/schema/scene.hpp>

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
TableKeys keys(std::string_view kind, std::string_view shown, const T* some = nullptr) {
  TableKeys table{kind, shown, {}};
  describe(Of<T>{}, KeyNames<T>(table.keys, some));
  return table;
}

/// A table that may be of several kinds, of which a key says which: all keys.
TableKeys together(std::string_view kind, const std::vector<TableKeys>& kinds) {
  TableKeys table{kind, kinds.front().shown, {}};
  for (const TableKeys& one : kinds) {
    for (const std::string_view key : one.keys) {
      if (!is_among(key, table.keys)) table.keys.push_back(key);
    }
  }
  return table;
}

std::vector<TableKeys> mesh_keys() {
  constexpr const char* shown = "body.NAME.mesh";
  std::vector<TableKeys> kinds{keys<BlockMesh>("block", shown), keys<RoundNosedRodMesh>("round_nosed_rod", shown),
                               keys<CylinderMesh>("cylinder", shown), keys<SphereMesh>("sphere", shown)};
  std::vector<TableKeys> by_ending;
  for (const auto& choice : choices(Of<MeshFormat>{})) {
    FileMesh mesh;
    mesh.format = choice.value;
    kinds.push_back(keys(choice.name, shown, &mesh));
    if (choice.value != MeshFormat::gmsh) by_ending.push_back(kinds.back());
  }
  kinds.push_back(together("file", by_ending));
  kinds.insert(kinds.begin(), together("mesh", kinds));
  return kinds;
}

std::vector<TableKeys> all_kinds() {
  std::vector<TableKeys> all{keys<Scene>("scene", ""),
                             keys<TimeSettings>("time", "time"),
                             keys<ElementSettings>("element", "element"),
                             keys<ElementSettings>("element of a body", "body.NAME.element"),
                             keys<ContactSettings>("contact", "contact"),
                             keys<ContactPair>("contact_pair", "contact.pair.NAME"),
                             keys<TiedContact>("contact_tied", "contact.tied.NAME"),
                             keys<SideOfSet>("contact_side", "{ elements, faces or nodes }"),
                             keys<SkipSettings>("skip", "skip"),
                             keys<GuardSettings>("guard", "guard"),
                             keys<OutputSettings>("output", "output"),
                             keys<Material>("material", "material.NAME"),
                             keys<OneYieldCurve>("yield_curve", "material.NAME.yield_curve"),
                             keys<YieldCurve>("yield_curves", "material.NAME.yield_curves"),
                             keys<Body>("body", "body.NAME")};
  for (TableKeys& mesh : mesh_keys()) all.push_back(std::move(mesh));
  const TableKeys symmetry = keys<PlaneConstraint>("symmetry", "constraint.NUMBER");
  const TableKeys fixed = keys<FixedConstraint>("fixed", "constraint.NUMBER");
  all.insert(
      all.end(),
      {together("constraint", {symmetry, fixed}), symmetry, fixed, keys<Plane>("plane", "plane"),
       keys<Line>("line", "line"), keys<Box>("box", "box"), keys<RigidWall>("rigid_wall", "rigid_wall.NAME"),
       keys<PrescribedVelocity>("prescribed_velocity", "prescribed_velocity.NUMBER"),
       keys<NodalLoad>("load", "load.NUMBER"), keys<Pressure>("pressure", "pressure.NUMBER"),
       keys<Gravity>("gravity", "gravity.NUMBER"), keys<InitialVelocity>("initial_velocity", "initial_velocity.NUMBER"),
       keys<DampingSettings>("damping", "damping"), keys<Probe>("probe", "probe.NAME")});
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
