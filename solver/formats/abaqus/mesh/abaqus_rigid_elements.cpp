#include "abaqus_rigid_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/point.hpp>
#include <solver/mesh/file/shell_layers.hpp>

namespace pinball {

namespace {

constexpr double behind_one_side = 0.25, between_two_sides = 0.05;  ///< thickness of a layer, in mean edges

/// Which sides of its elements the surfaces of a deck have.
struct SidesOfElements {
  bool positive = false, negative = false;
};

using Nodes4 = std::array<std::int32_t, 4>;

class RigidElements {
 public:
  RigidElements(AbaqusMesh& mesh, MeshFile& file) : mesh_(mesh), file_(file) {
    for (std::size_t e = 0; e < file_.mesh.hexahedra.size(); ++e) {
      if (is_flat_layer(file_.mesh.hexahedra[e])) add(static_cast<std::int32_t>(e));
    }
  }

  void thicken(std::vector<std::int32_t> references) {
    find_sides();
    for (std::size_t part = 0; part < mesh_.sections.size(); ++part) set_thickness(static_cast<std::int32_t>(part));
    add_shell_layers(shells_, file_);
    std::ranges::sort(references);
    put_layers_into_sets(file_, LayerFaces::facing, references);
  }

 private:
  void add(std::int32_t element) {
    RigidShell shell;
    shell.id = file_.element_ids[element];
    shell.part = file_.part[element];
    shell.line = file_.line[element];
    shell.nodes = positive_side(file_.mesh.hexahedra[element]);
    shell.element = element;
    shells_.push_back(shell);
  }

  void find_sides() {
    std::map<Nodes4, std::vector<const RigidShell*>> of_nodes;
    for (const RigidShell& shell : shells_) of_nodes[key_of_shell(shell.nodes)].push_back(&shell);
    for (const FaceSet& set : file_.face_sets) {
      for (const Nodes4& face : set.faces) {
        const auto found = of_nodes.find(key_of_shell(face));
        if (found == of_nodes.end()) continue;
        for (const RigidShell* shell : found->second) {
          const bool positive = go_round_alike(face, shell->nodes);
          SidesOfElements& sides = sides_[shell->part];
          (positive ? sides.positive : sides.negative) = true;
        }
      }
    }
  }

  /// Mean length of the edges of a part [length]; 0: it has none.
  double mean_edge(std::int32_t part) const {
    double sum = 0;
    std::size_t count = 0;
    for (const RigidShell& shell : shells_) {
      if (shell.part != part) continue;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::int32_t from = shell.nodes[k], to = shell.nodes[(k + 1) % 4];
        if (from == to) continue;
        sum += norm(minus(file_.mesh.nodes[to], file_.mesh.nodes[from]));
        ++count;
      }
    }
    return count == 0 ? 0.0 : sum / static_cast<double>(count);
  }

  void set_thickness(std::int32_t part) {
    const double edge = mean_edge(part);
    if (edge == 0) return;
    const AbaqusSection& section = mesh_.sections[part];
    const SidesOfElements sides = sides_[part];
    double thickness = given_thickness(*section.block), shift = 0;
    const char* where = "half of it on each side";
    if (thickness == 0) {
      const bool one = sides.positive != sides.negative;
      thickness = (one ? behind_one_side : between_two_sides) * edge;
      if (one) {
        shift = sides.positive ? -0.5 : 0.5;
        where = "behind the side that surfaces have";
      }
    }
    for (RigidShell& shell : shells_) {
      if (shell.part != part) continue;
      shell.thickness = thickness;
      shell.shift = shift;
    }
    file_.notes.push_back(fmt::format("*RIGID BODY ({}): its rigid elements are a layer of solids {:.6g} thick, {}",
                                      section.block->place.text(), thickness, where));
  }

  static double given_thickness(const AbaqusBlock& block) {
    DataLines lines(block);
    const auto card = lines.next();
    if (!card) return 0;
    const double thickness = DataFields(*card).number(0, "thickness", 0.0);
    if (!(thickness >= 0))
      fail_at(card->place, fmt::format("*RIGID BODY: thickness: expected a number >= 0, got {}", thickness));
    return thickness;
  }

  AbaqusMesh& mesh_;
  MeshFile& file_;
  std::vector<RigidShell> shells_;
  std::map<std::int32_t, SidesOfElements> sides_;  ///< by parts
};

}  // namespace

int nodes_of_rigid_element(const std::string& type) { return type == "R3D4" ? 4 : type == "R3D3" ? 3 : 0; }

bool is_point_element(const std::string& type) { return type == "MASS" || type == "ROTARYI"; }

std::array<std::int32_t, 4> positive_side(const std::array<std::int32_t, 8>& hexahedron) {
  return {hexahedron[0], hexahedron[1], hexahedron[2], hexahedron[3]};
}

std::array<std::int32_t, 4> negative_side(const std::array<std::int32_t, 8>& hexahedron) {
  const auto& n = hexahedron;
  if (n[3] == n[2]) return {n[1], n[0], n[2], n[2]};
  return {n[3], n[2], n[1], n[0]};
}

void thicken_rigid_elements(AbaqusMesh& mesh, MeshFile& file, std::vector<std::int32_t> references) {
  if (std::ranges::any_of(file.mesh.hexahedra, is_flat_layer)) RigidElements(mesh, file).thicken(std::move(references));
}

}  // namespace pinball
