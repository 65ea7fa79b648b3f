#include "numbered_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/held_mesh.hpp>
#include <solver/mesh/number_index.hpp>

namespace pinball {

namespace {

using FaceNumbers = std::array<std::int64_t, 4>;

/// visit(selection, key) for all that may list nodes; pressures apart, which list faces as well.
template <class SceneOrConst, class Visit>
void for_each_list(SceneOrConst& scene, const Visit& visit) {
  const auto all = [&visit](auto& items, const char* name, const auto& selection) {
    for (std::size_t i = 0; i < items.size(); ++i) visit(selection(items[i]), fmt::format("{}.{}.nodes", name, i));
  };
  const auto nodes = [](auto& item) -> auto& { return item.nodes; };
  all(scene.fixed_constraints, "constraint", nodes);
  all(scene.equation_terms, "equation", nodes);
  all(scene.attached_nodes, "rigid_nodes", nodes);
  all(scene.rigid_walls, "rigid_wall", nodes);
  all(scene.prescribed_velocities, "prescribed_velocity", nodes);
  all(scene.loads, "load", nodes);
  all(scene.point_masses, "point_mass", nodes);
  all(scene.initial_velocities, "initial_velocity", nodes);
  all(scene.initial_stresses, "initial_stress", nodes);
  all(
      scene.pressures, "pressure", [](auto& item) -> auto& { return item.faces; });
}

bool is_of(const NodeSelection& selection, const FileMesh& mesh) { return mesh.file.ends_with(selection.file); }

/// A mesh with the sets that are listed of it.
class NumberedMesh {
 public:
  NumberedMesh(const FileMesh& settings, const std::vector<std::string>& parts) : settings_(settings) {
    FileMesh plain = settings;
    plain.splits = 0;
    plain.scale = 1;  // scaled and split where it is taken
    plain.held.reset();
    file_ = read_mesh_file(plain, parts);
    places_ = NumberIndex(file_.node_ids);
  }

  void add_nodes(const NodeSelection& selection, const std::string& name) {
    MeshSet set{0, name, {}};
    for (const std::int64_t number : selection.nodes) set.members.push_back(place_of(number, selection));
    file_.node_sets.push_back(std::move(set));
  }
  void add_faces(const Pressure& pressure, const std::string& name) {
    FaceSet set{0, name, {}};
    for (const FaceNumbers& numbers : pressure.corners) {
      auto& corners = set.faces.emplace_back();
      for (std::size_t c = 0; c < 4; ++c) corners[c] = place_of(numbers[c], pressure.faces);
    }
    file_.face_sets.push_back(std::move(set));
  }
  std::shared_ptr<HeldMesh> held() && { return std::make_shared<HeldMesh>(std::move(file_), settings_); }

 private:
  std::int32_t place_of(std::int64_t number, const NodeSelection& selection) const {
    const bool by_place = file_.node_ids.empty();
    const std::int64_t count = file_.mesh.nodes.size();
    const std::int32_t place = !by_place ? places_.find(number) : number >= 0 && number < count ? number : -1;
    if (place >= 0) return place;
    throw InputError(fmt::format("{}: {} has no node {}", selection.where, file_.path, number));
  }

  FileMesh settings_;
  MeshFile file_;
  NumberIndex places_;
};

bool lists_numbers(const Scene& scene) {
  bool any = std::any_of(scene.pressures.begin(), scene.pressures.end(),
                         [](const Pressure& pressure) { return !pressure.corners.empty(); });
  for_each_list(scene, [&any](const NodeSelection& selection, const std::string&) { any |= !selection.nodes.empty(); });
  return any;
}

void add_lists(Scene& scene, NumberedMesh& numbered, const FileMesh& mesh) {
  for_each_list(scene, [&](const NodeSelection& selection, const std::string& key) {
    if (!selection.nodes.empty() && is_of(selection, mesh)) numbered.add_nodes(selection, key);
  });
  for (const Pressure& pressure : scene.pressures) {
    if (!pressure.corners.empty() && is_of(pressure.faces, mesh)) {
      numbered.add_faces(pressure, fmt::format("pressure.{}.faces", pressure.name));
    }
  }
}

void name_sets(Scene& scene) {
  for_each_list(scene, [](NodeSelection& selection, const std::string& key) {
    if (selection.nodes.empty()) return;
    selection.set = key;
    selection.nodes.clear();
  });
  for (Pressure& pressure : scene.pressures) {
    if (pressure.corners.empty()) continue;
    pressure.faces.set = fmt::format("pressure.{}.faces", pressure.name);
    pressure.corners.clear();
  }
}

bool is_one_node(const NodeSelection& selection) { return selection.nearest || selection.nodes.size() == 1; }

/// Whether some of its nodes may be of a mesh whose elements are split.
bool may_be_split(const Scene& scene, const NodeSelection& selection) {
  return std::ranges::any_of(scene.bodies, [&selection](const Body& body) {
    return (selection.body.empty() || selection.body == body.name) && std::holds_alternative<FileMesh>(body.mesh);
  });
}

/// Terms of an equation have their nodes in an order, in which new ones have no place.
void require_pairs_that_carry(const Scene& scene) {
  for (std::size_t i = 0; i < scene.equation_terms.size(); ++i) {
    const EquationTerm& term = scene.equation_terms[i];
    if (is_one_node(term.nodes)) continue;
    for (std::size_t other = 0; other < i; ++other) {
      const EquationTerm& before = scene.equation_terms[other];
      if (before.name != term.name || is_one_node(before.nodes)) continue;
      if (!may_be_split(scene, term.nodes) && !may_be_split(scene, before.nodes)) continue;
      throw InputError(
          fmt::format("equation.{}: expected nodes of generated meshes, or one node, beside the nodes of equation.{}: "
                      "nothing says which of their new nodes belong together where the elements of a file are split",
                      i, other));
    }
  }
}

bool are_of_one_file(const FileMesh& a, const FileMesh& b) {
  return a.file == b.file && a.format == b.format && a.chosen_case == b.chosen_case;
}

}  // namespace

void carry_numbers(Scene& scene) {
  std::vector<FileMesh*> meshes;
  for (Body& body : scene.bodies) {
    if (auto* mesh = std::get_if<FileMesh>(&body.mesh); mesh != nullptr && mesh->splits > 0) meshes.push_back(mesh);
  }
  if (meshes.empty() || !lists_numbers(scene)) return;
  std::vector<bool> done(meshes.size(), false);
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (done[m]) continue;
    std::vector<std::string> parts;
    for (const FileMesh* other : meshes) {
      if (are_of_one_file(*other, *meshes[m])) parts.push_back(other->part);
    }
    NumberedMesh numbered(*meshes[m], parts);
    add_lists(scene, numbered, *meshes[m]);
    const auto held = std::move(numbered).held();
    for (std::size_t other = m; other < meshes.size(); ++other) {
      if (!are_of_one_file(*meshes[other], *meshes[m])) continue;
      done[other] = true;
      meshes[other]->held = held;
    }
  }
  name_sets(scene);
}

void require_numbers_that_carry(const Scene& scene) {
  const auto fail = [](const std::string& key, const char* problem) {
    throw InputError(fmt::format("{}: expected {}", key, problem));
  };
  for_each_list(scene, [&fail](const NodeSelection& selection, const std::string& key) {
    if (selection.nodes.empty() || selection.set.empty()) return;
    fail(key, "a set or numbers, and not both, where the elements of a file are split");
  });
  for (const Pressure& pressure : scene.pressures) {
    if (pressure.corners.empty() || (pressure.faces.set.empty() && pressure.faces.nodes.empty())) continue;
    fail(fmt::format("pressure.{}.faces", pressure.name), "faces alone where the elements of a file are split");
  }
  require_pairs_that_carry(scene);
  for (std::size_t i = 0; i < scene.initial_stresses.size(); ++i) {
    if (scene.initial_stresses[i].elements.empty()) continue;
    fail(fmt::format("initial_stress.{}.elements", i),
         "a set or a place of elements: on a finer mesh there are eight in the place of one");
  }
  for (const Probe& probe : scene.probes) {
    if (!probe.number || probe.kind != ProbeKind::element) continue;
    fail(fmt::format("probe.{}.element", probe.name),
         "a node or a point: on a finer mesh there are eight in its place");
  }
}

}  // namespace pinball
