#include "scene_schema.hpp"

#include <cmath>

#include "table_schema.hpp"

namespace pinball {

namespace {

SchemaJson required(std::initializer_list<const char*> keys) { return {{"required", keys}}; }
/// Where a key has a value.
SchemaJson where(const char* key, const SchemaJson& value) {
  return {{"properties", {{key, {{"const", value}}}}}, {"required", {key}}};
}
SchemaJson none_of(std::initializer_list<const char*> keys) {
  SchemaJson any = SchemaJson::array();
  for (const char* key : keys) any.push_back(required({key}));
  return {{"not", {{"anyOf", any}}}};
}

/// What is to be given of "which nodes".
SchemaJson some_nodes() {
  SchemaJson any = SchemaJson::array();
  for (const char* key : {"body", "plane", "line", "box", "nearest", "set", "nodes"}) any.push_back(required({key}));
  return {{"anyOf", any}};
}

/// Of cylinders and spheres: what only wedges have, and what they have not.
SchemaJson if_wedge(const SchemaJson& then, const SchemaJson& otherwise) {
  return {{"if", where("section", "wedge")}, {"then", then}, {"else", otherwise}};
}

SchemaJson mesh_definitions(SchemaJson& all) {
  SchemaJson kinds = SchemaJson::array();
  const auto add = [&](const std::string& name, SchemaJson table) {
    kinds.push_back(reference("mesh_" + name));
    all["mesh_" + name] = std::move(table);
  };
  add("block", table_schema<BlockMesh>());
  add("round_nosed_rod", table_schema<RoundNosedRodMesh>());
  SchemaJson cylinder = table_schema<CylinderMesh>(), sphere = table_schema<SphereMesh>();
  SchemaJson wedge = none_of({"core", "ring"});
  wedge.update(required({"angle", "radial"}));
  SchemaJson other = none_of({"angle", "radial"});
  other.update(required({"core"}));
  cylinder.update(if_wedge(wedge, other));
  SchemaJson two{{"properties", {{"core", {{"type", "array"}}}}}, {"required", {"angle"}}};
  SchemaJson one{{"properties", {{"core", {{"type", "integer"}}}}}, {"not", required({"angle"})}};
  sphere.update(if_wedge(two, one));
  add("cylinder", cylinder);
  add("sphere", sphere);
  SchemaJson by_ending;
  for (const auto& choice : schema::choices(schema::Of<MeshFormat>{})) {
    FileMesh mesh;
    mesh.format = choice.value;
    SchemaJson table = table_schema(&mesh);
    if (choice.value != MeshFormat::gmsh) {
      if (by_ending.is_null()) by_ending = table;
      by_ending["properties"].update(table["properties"]);
    }
    table["properties"]["type"]["enum"] = {choice.name};
    add(choice.name, table);
  }
  by_ending["properties"]["type"]["enum"] = {"file"};
  add("file", by_ending);
  return {{"anyOf", kinds}};
}

/// One of two.
SchemaJson either(const SchemaJson& one, const SchemaJson& other) { return {{"oneOf", {one, other}}}; }

/// A table, with what its keys have to do with each other.
template <class T>
void define(SchemaJson& all, const SchemaJson& rule = {}, const SchemaJson& another = {}) {
  SchemaJson table = table_schema<T>();
  if (!rule.is_null()) table["allOf"].push_back(rule);
  if (!another.is_null()) table["allOf"].push_back(another);
  all[kind(schema::Of<T>{}).name] = std::move(table);
}

/// A table of a material, without what it requires, which goes to `required`.
template <class T>
void define_table_of_material(SchemaJson& all, SchemaJson& required) {
  SchemaJson table = table_schema<T>();
  const char* const name = kind(schema::Of<T>{}).name;
  if (table.contains("required")) {
    for (const std::string key : table["required"]) table["properties"][key]["x-default"] = "required";
    required[name] = {{"required", table["required"]}};
    table.erase("required");
  }
  all[name] = std::move(table);
}

template <class... T>
SchemaJson define_tables_of_material(SchemaJson& all, schema::Types<T...> /*tables*/) {
  SchemaJson required = SchemaJson::object();
  (define_table_of_material<T>(all, required), ...);
  return required;
}

/// What is required, but where a published material gives it. of_tables: what the tables in it require.
SchemaJson material_schema(const SchemaJson& of_tables) {
  SchemaJson table = table_schema<Material>();
  const SchemaJson yield{
      {"if", where("model", "von_mises")},
      {"then",
       {{"anyOf",
         {required({"yield_stress"}), required({"yield_curve"}), required({"yield_curves"}), required({"fluid"}),
          required({"johnson_holmquist"}), required({"drucker_prager"}), required({"crushable_foam"})}}}}};
  const SchemaJson moduli{{"oneOf",
                           {required({"bulk_modulus", "shear_modulus"}), required({"young_modulus", "poisson_ratio"}),
                            required({"equation_of_state", "shear_modulus"}), required({"mooney_rivlin"}),
                            required({"ogden"}), required({"orthotropic"}), required({"equation_of_state", "fluid"})}}};
  const SchemaJson all_of_it{{"required", table["required"]}, {"properties", of_tables}, {"allOf", {moduli, yield}}};
  table["required"] = {"name"};
  table["allOf"] = {{{"if", required({"use"})}, {"then", SchemaJson::object()}, {"else", all_of_it}}};
  return table;
}

SchemaJson definitions() {
  SchemaJson all;
  define<TimeSettings>(all);
  define<ElementSettings>(all, {{"dependencies", {{"hourglass_coefficient", {"hourglass"}}}}});
  define<ContactSettings>(all);
  define<ContactPair>(all);
  define<TiedContact>(all);
  define<schema::SideOfSet>(all, {{"oneOf", {required({"elements"}), required({"faces"}), required({"nodes"})}}});
  define<SkipSettings>(all);
  define<GuardSettings>(all);
  define<OutputSettings>(all);
  define<DampingSettings>(all);
  SchemaJson of_material;
  all[kind(schema::Of<Material>{}).name] =
      material_schema(define_tables_of_material(of_material, schema::TablesOfMaterial{}));
  define<schema::OneYieldCurve>(all);
  define<YieldCurve>(all);
  all.update(of_material);
  define<Body>(all);
  all["mesh"] = mesh_definitions(all);
  define<RigidBody>(all);
  define<AttachedNodes>(all, some_nodes());
  define<RigidMotion>(all, {{"oneOf", {required({"direction"}), required({"axis"})}}});
  define<Joint>(all);
  define<Plane>(all);
  define<Line>(all);
  define<Box>(all);
  define<PlaneConstraint>(all);
  define<FixedConstraint>(
      all, some_nodes(),
      {{"if", where("frame", "cylindrical")}, {"then", required({"axis"})}, {"else", {{"not", required({"axis"})}}}});
  define<EquationTerm>(all, some_nodes());
  define<RigidWall>(all);
  define<PrescribedVelocity>(all, some_nodes(), either(required({"velocity"}), required({"direction", "speed"})));
  define<NodalLoad>(all, some_nodes());
  define<Pressure>(all, {{"anyOf", {required({"faces"}), some_nodes()}}});
  define<Gravity>(all);
  define<PointMass>(all, some_nodes());
  define<InitialVelocity>(all, some_nodes(), {{"anyOf", {required({"velocity"}), required({"angular_velocity"})}}});
  define<InitialStress>(all, {{"anyOf", {required({"elements"}), some_nodes()}}});
  define<Probe>(all, {{"oneOf", {required({"point"}), required({"node"}), required({"element"})}}});
  return all;
}

/// The paths of the keys of which a scene has one each.
template <class T>
class Paths {
 public:
  Paths(std::vector<std::string>& paths, std::string table) : paths_(paths), table_(std::move(table)) {}

  template <class Value>
  void operator()(const schema::FileKey<Value>& key) const {
    paths_.push_back(table_ + key.name);
  }
  template <class Value>
  void operator()(const schema::Field<T, Value>&) const {}
  template <class Part>
  void operator()(const schema::Tables<T, Part>& tables) const {
    describe(schema::Of<Part>{}, Paths<Part>(paths_, std::string(tables.name) + '.'));
  }
  /// Of these there may be any number.
  template <class Part>
  void operator()(const schema::Tables<T, std::vector<Part>>&) const {}

 private:
  std::vector<std::string>& paths_;
  std::string table_;
};

}  // namespace

SchemaJson number_schema(const Bound& bound, bool whole) {
  SchemaJson number{{"type", whole ? "integer" : "number"}};
  const auto as_number = [whole](double value) -> SchemaJson {
    if (whole) return static_cast<std::int64_t>(value);
    return value;
  };
  if (std::isfinite(bound.low)) number[bound.low_open ? "exclusiveMinimum" : "minimum"] = as_number(bound.low);
  if (std::isfinite(bound.high)) number[bound.high_open ? "exclusiveMaximum" : "maximum"] = as_number(bound.high);
  return number;
}

SchemaJson array_schema(const SchemaJson& items, std::optional<std::size_t> count) {
  SchemaJson array{{"type", "array"}, {"items", items}};
  if (count) array["minItems"] = array["maxItems"] = *count;
  return array;
}

SchemaJson texts_schema(std::span<const std::string_view> texts) {
  SchemaJson names = SchemaJson::array();
  for (const std::string_view text : texts) names.push_back(std::string(text));
  return {{"enum", names}};
}

std::string scene_schema() {
  SchemaJson scene{{"$schema", "http://json-schema.org/draft-07/schema#"},
                   {"title", "Pinball scene"},
                   {"description", "A scene file of Pinball (TOML). What no schema can say, the program does."}};
  scene.update(table_schema<Scene>());
  scene["required"] = {"time", "material", "body"};
  scene["definitions"] = definitions();
  return scene.dump(2);
}

std::vector<std::string> settable_keys() {
  std::vector<std::string> paths;
  describe(schema::Of<Scene>{}, Paths<Scene>(paths, ""));
  return paths;
}

}  // namespace pinball
