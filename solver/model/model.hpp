#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <kernels/boundary/held_nodes.hpp>
#include <solver/base/colouring.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/base/tied_result.hpp>
#include <solver/contact/tied/tied_nodes.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/scene.hpp>

#include "look/look.hpp"
#include "material/yield_curves.hpp"
#include "stores.hpp"

namespace pinball {

/// What a mesh file calls the nodes of some bodies.
struct FileNodes {
  std::string path;
  std::vector<std::pair<std::int64_t, std::int32_t>> numbers;  ///< number in the file and node, by number; may be empty
  std::vector<std::pair<std::int64_t, std::int32_t>> element_numbers{};  ///< the same of elements
  std::vector<MeshSet> sets;                                             ///< of nodes of the model
  std::vector<MeshSet> element_sets;  ///< of elements of the model; parts, and then sets
  std::vector<FaceSet> face_sets;     ///< of nodes of the model, those of its elements alone
  std::vector<MeshGroup> groups{};    ///< all parts and sets of the file
  std::vector<MeshSource> sources{};  ///< the file, and those that it includes
};

/// The meshes of all bodies together, in the order of the scene; cold.
struct ModelMesh {
  std::vector<Point> nodes;
  std::vector<std::array<std::int32_t, 8>> hexahedra;
  std::vector<std::int32_t> body;          ///< per element
  std::vector<std::int32_t> body_of_node;  ///< per node; of a node that bodies share the first of them
  std::vector<std::string> body_names;
  std::vector<std::vector<std::int32_t>> shared;  ///< per body: nodes of its elements that an earlier body has; sorted
  std::vector<FileNodes> files;                   ///< of the bodies that are from files
  std::vector<std::int32_t> file_of_body{};       ///< place in `files`, per body; -1: it is from none
  std::vector<std::string> warnings{};            ///< what is wrong with meshes of files
  std::vector<float> edge;  ///< per node the shortest edge of its elements; empty: nothing asks for it [length]

  std::int64_t element_count() const { return hexahedra.size(); }
  const std::string& body_of_element(std::int64_t element) const { return body_names[body[element]]; }
  /// Place of corner 0 to 7 of an element [length].
  const Point& corner(std::int64_t element, int i) const { return nodes[hexahedra[element][i]]; }
  std::array<Point, 8> corners(std::int64_t element) const { return corners_of(hexahedra[element]); }
  std::array<Point, 8> corners_of(const std::array<std::int32_t, 8>& hexahedron) const {
    std::array<Point, 8> points;
    for (std::size_t i = 0; i < 8; ++i) points[i] = nodes[hexahedron[i]];
    return points;
  }
};

/// Elements of one material with one kind of settings (element_parts.hpp): consecutive tiles, computed by one
/// specialised kernel.
struct Part {
  std::int32_t material = 0;
  ElementFeatures features{};
  ElementSettings settings;
  bool rigid = false;  ///< of rigid bodies: no kernel works them
};

/// A rigid body: which nodes move with it, and in which directions nothing moves it.
struct RigidNodes {
  std::int32_t first_body = 0;        ///< the first of the scene's that it is made of
  std::vector<std::int32_t> nodes;    ///< of the store, ascending
  std::vector<Point> held;            ///< along which its centre does not move, orthonormal
  std::vector<Point> held_rotations;  ///< about which it does not turn, orthonormal
};

/// Steps that a tile may make where elements have steps of their own (step_levels.hpp).
struct TileLevels {
  std::uint8_t highest;  ///< level of all its elements
  std::uint8_t own;      ///< lowest level that its elements would have by themselves
};

/// Consecutive slots, for `for (const std::int64_t slot : range)`.
struct SlotRange {
  std::int64_t first = 0, last = 0;  ///< of them, and the one after them

  struct Iterator {
    std::int64_t slot;
    std::int64_t operator*() const { return slot; }
    Iterator& operator++() {
      ++slot;
      return *this;
    }
    bool operator==(const Iterator&) const = default;
  };
  Iterator begin() const { return {first}; }
  Iterator end() const { return {last}; }
};

/// A scene made ready to run: stores, tiles and colours, and the maps between the order of the scene and that of the
/// stores. Elements are sorted by material, with subcycling also by their steps, and into tiles; nodes follow their
/// elements.
template <class S>
struct Model {
  Scene scene;
  ModelMesh mesh;
  Look look;

  NodeStore<S> nodes;
  ElementStore elements;
  std::vector<ElementConstants<S>> constants;                       ///< per part
  std::vector<std::shared_ptr<const YieldCurves<S>>> yield_curves;  ///< what `constants` point to
  /// The same for elements of single precision, where nodes have double; else empty.
  std::vector<ElementConstants<float>> single_constants;
  std::vector<std::shared_ptr<const YieldCurves<float>>> single_yield_curves;
  std::vector<Part> parts;
  std::vector<NodeConstraint<S>> constraints;   ///< orthonormal per node
  std::vector<NodePrescription<S>> prescribed;  ///< orthonormal per node, with the constraints

  std::vector<RigidNodes> rigid;            ///< per rigid body of the scene
  std::vector<std::int32_t> rigid_of_body;  ///< per body of the scene: number of its rigid body; -1: it deforms

  std::vector<TiedNode> tied_nodes;         ///< in the numbers of the stores
  std::vector<TiedResult> tie_counts;       ///< per tied contact
  const S* contact_inverse_mass = nullptr;  ///< what contact by springs divides by; null: that of the nodes [1/mass]
  /// Nodes whose masses ties have moved, with those that they have without ties [mass].
  const std::vector<std::pair<std::int32_t, double>>* masses_without_ties = nullptr;

  std::vector<std::int64_t> tile_packs;  ///< first pack of each tile; tiles + 1 entries
  std::vector<std::int32_t> tile_part;   ///< per tile
  std::vector<std::int32_t> tile_body;   ///< per tile; empty where tiles may be of several (output.body_energies)
  Colouring tile_colours;
  std::vector<TileLevels> tile_levels;  ///< per tile; empty without subcycling

  std::vector<std::int32_t> element_of_slot;     ///< scene number of the element, -1 for padding
  std::vector<std::int64_t> slot_of_element;     ///< per element of the scene
  std::vector<std::int32_t> node_of_scene_node;  ///< store number per node of the scene
  std::vector<double> element_mass;              ///< initial, with what is added, per element of the scene [mass]
  std::vector<double> added_mass;                ///< the part of it that no material has; empty: none [mass]
  std::vector<double> node_mass;                 ///< per node of the store [mass]
  std::vector<double> added_node_mass;           ///< the part of it that time.smallest_step adds; empty: none [mass]
  std::vector<double> point_mass;                ///< the part of it that no element has; empty: none [mass]

  std::int64_t element_count() const { return mesh.element_count(); }
  double material_mass(std::size_t element) const {
    return added_mass.empty() ? element_mass[element] : element_mass[element] - added_mass[element];
  }
  double material_mass_of_node(std::size_t node) const {
    double mass = node_mass[node];
    if (!point_mass.empty()) mass -= point_mass[node];
    if (!added_node_mass.empty()) mass -= added_node_mass[node];
    return mass;
  }
  std::int32_t tile_count() const { return tile_part.size(); }
  /// Slots of a tile, its padding among them.
  SlotRange slots_of(std::int64_t tile) const {
    const int W = elements.width;
    return {tile_packs[tile] * W, tile_packs[tile + 1] * W};
  }
  std::int64_t rigid_element_count() const {
    return std::ranges::count_if(mesh.body, [this](std::int32_t body) { return rigid_of_body[body] >= 0; });
  }
  /// Whether the elements of a tile are of a rigid body.
  bool is_rigid(std::int64_t tile) const { return parts[tile_part[tile]].rigid; }
  /// Whether any elements have volumes that are averaged over nodes.
  bool averages_volumes() const {
    return std::ranges::any_of(constants, [](const ElementConstants<S>& of) { return of.averaged_volumes; });
  }
  /// Number of the part that the element of a slot is of.
  std::size_t part_of_slot(std::int64_t slot) const {
    const auto tile = std::upper_bound(tile_packs.begin(), tile_packs.end(), slot / elements.width);
    return tile_part[tile - tile_packs.begin() - 1];
  }
  bool is_padding(std::int64_t slot) const { return element_of_slot[slot] < 0; }
  /// Whether a number that was read is the slot of an element, or negative: none.
  bool may_be_place(std::int64_t slot) const { return slot < 0 || (slot < elements.slots && !is_padding(slot)); }
  /// Per part, in the precision of the elements.
  template <class E>
  std::vector<ElementConstants<E>>& constants_in() {
    if constexpr (std::is_same_v<E, S>) {
      return constants;
    } else {
      return single_constants;
    }
  }
  std::size_t bytes() const;  ///< of all arrays of the size of the mesh
  /// The state of nodes and elements between steps: node forces are zero then.
  void persist(StateArchive& archive);
};

/// Whether the nodes of a model of this scene have more digits than its elements.
template <class S>
bool is_mixed(const Scene& scene) {
  return std::is_same_v<S, double> && scene.precision == Precision::mixed;
}
/// Whether its elements have numbers of single precision.
template <class S>
bool has_single_elements(const Scene& scene) {
  return std::is_same_v<S, float> || is_mixed<S>(scene);
}

/// How a message about a scene begins: "FILE: ", or nothing for a scene that was made in code.
std::string message_head(const Scene& scene);

/// Number of the material of each body. Throws InputError if there is none of that name.
std::vector<std::size_t> material_of_bodies(const Scene& scene);

/// Generates and places the meshes of all bodies. Throws InputError for an inverted or flat element, naming it.
ModelMesh build_mesh(const Scene& scene);

/// Exact volume of an element [length^3].
double element_volume(const ModelMesh& mesh, std::size_t element);

/// Mean of an element's eight nodes [length].
Point element_centre(const ModelMesh& mesh, std::size_t element);
/// Edges of the box around an element [length].
Point element_extent(const ModelMesh& mesh, std::size_t element);

/// Nodes that are held, or moved as given, at a time; the directions of a node are at right angles.
template <class S>
struct HeldNodes {
  std::vector<NodeConstraint<S>> constraints;
  std::vector<NodePrescription<S>> prescribed;
};
/// Throws InputError for a selection without nodes.
template <class S>
HeldNodes<S> held_nodes(const Model<S>& model, double time);
/// Fills in those of a time in place of those that are there.
template <class S>
void set_constraints(Model<S>& model, double time);

/// Builds the stores. Throws InputError for what only the mesh shows to be wrong.
template <class S>
Model<S> build_model(const Scene& scene);

}  // namespace pinball
