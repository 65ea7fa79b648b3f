#include "model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/base/point.hpp>
#include <solver/base/tile_size.hpp>
#include <solver/model/selection/left_out.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/scene_rules.hpp>

#include "elements/element_parts.hpp"
#include "elements/element_start.hpp"
#include "elements/folding_onsets.hpp"
#include "elements/mass_scaling.hpp"
#include "initial_overlap.hpp"
#include "initial_stresses.hpp"
#include "initial_velocities.hpp"
#include "interfaces/tied_at_walls.hpp"
#include "interfaces/ties.hpp"
#include "material/material_laws.hpp"
#include "model_parts.hpp"
#include "moved_nodes.hpp"
#include "ordering.hpp"
#include "point_masses.hpp"
#include "rigid/rigid_nodes.hpp"
#include "step_levels.hpp"

namespace pinball {

namespace {

/// Elements of one part and one level of steps, and of one body where that is asked for, cut into tiles of whole packs
/// of any width.
struct TileGroup {
  std::size_t part = 0;
  std::uint8_t level = 0;
  std::int32_t body = 0;
  TileOrder tiles;
};

/// The direction of most first axes of some elements, along which mixed precision fetches rows of them at once.
int axis_of_rows(const ModelMesh& mesh, const std::vector<std::int32_t>& elements) {
  Point sum{};
  for (const std::int32_t e : elements) {
    const Point edge = minus(mesh.corner(e, 1), mesh.corner(e, 0));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += std::abs(edge[k]) / std::sqrt(dot(edge, edge));
  }
  return static_cast<int>(std::ranges::max_element(sum) - sum.begin());
}

/// levels: of the steps of the elements; empty if all make the same. by_body: no tile is of several bodies. pack: lanes
/// of the widest.
std::vector<TileGroup> cut_into_tiles(const ElementParts& parts, const ModelMesh& mesh,
                                      const std::vector<std::uint8_t>& levels, bool by_body, int pack, bool mixed) {
  const std::size_t count = mesh.hexahedra.size();
  using Kind = std::tuple<std::size_t, std::uint8_t, std::int32_t>;
  std::map<Kind, std::vector<std::int32_t>> members;
  Array<Point> centres(count), extents(count);  // whose pages come with those who write
  parallel_for("places of elements", RangePolicy<>{0, mesh.element_count()}, [&](std::int64_t e) {
    centres[e] = element_centre(mesh, e);
    extents[e] = element_extent(mesh, e);
  });
  std::pair<const Kind, std::vector<std::int32_t>>* last = nullptr;
  for (std::size_t e = 0; e < count; ++e) {
    const std::int32_t body = mesh.body[e];
    const Kind kind{parts.part_of(mesh, e), levels.empty() ? std::uint8_t{0} : levels[e], by_body ? body : 0};
    if (last == nullptr || last->first != kind) last = &*members.try_emplace(kind).first;
    last->second.push_back(e);
  }
  std::vector<TileGroup> groups;
  for (auto& [kind, elements] : members) {
    // Threads share the tiles of one level: each level needs several.
    const std::size_t together = levels.empty() ? count : elements.size();
    const std::int64_t size = tile_size(together);
    const auto [part, level, body] = kind;
    const int axis = mixed ? axis_of_rows(mesh, elements) : -1;
    groups.push_back(
        {part, level, body,
         compact_tiles({centres.data(), count}, {extents.data(), count}, std::move(elements), size, pack, axis)});
  }
  return groups;
}

using Hexahedra = std::vector<std::array<std::int32_t, 8>>;

/// Tiles, each of whole packs of one material, and their colours; returns the elements in the order of their slots.
template <class S>
Hexahedra add_tiles(Model<S>& model, const ElementParts& parts, const std::vector<double>& mass_factor) {
  const bool single = has_single_elements<S>(model.scene);
  const int W = ElementStore::width_in(single);
  const ElementLevels levels =
      model.scene.time.subcycling ? element_step_levels(model.scene, model.mesh, mass_factor) : ElementLevels{};
  Hexahedra ordered(model.mesh.hexahedra.size());
  std::vector<std::int32_t> tile_elements{0};
  model.tile_packs.push_back(0);
  model.slot_of_element.resize(model.mesh.hexahedra.size());
  const bool by_body = model.scene.output.body_energies;
  for (const TileGroup& group :
       cut_into_tiles(parts, model.mesh, levels.level, by_body, single ? widest_pack<float> : widest_pack<double>,
                      is_mixed<S>(model.scene))) {
    const TileOrder& tiles = group.tiles;
    const std::int64_t first_tile = std::ssize(tile_elements) - 1, first_element = tile_elements.back();
    const std::int64_t count = std::ssize(tiles.offsets) - 1;
    for (std::int64_t t = 0; t < count; ++t) {
      const std::int64_t elements = tiles.offsets[t + 1] - tiles.offsets[t];
      model.tile_packs.push_back(model.tile_packs.back() + (elements + W - 1) / W);
      model.tile_part.push_back(group.part);
      if (by_body) model.tile_body.push_back(group.body);
      tile_elements.push_back(first_element + tiles.offsets[t + 1]);
    }
    if (!levels.own.empty()) model.tile_levels.resize(first_tile + count);
    model.element_of_slot.resize(model.tile_packs.back() * W, -1);
    parallel_for("elements of tiles", RangePolicy<>{0, count}, [&](std::int64_t t) {
      const std::int64_t first = tiles.offsets[t], last = tiles.offsets[t + 1];
      const std::int64_t slot = model.tile_packs[first_tile + t] * W;
      std::uint8_t own = highest_step_level;
      for (std::int64_t i = first; i < last; ++i) {
        const std::int32_t e = tiles.order[i];
        if (!levels.own.empty()) own = std::min(own, levels.own[e]);
        model.slot_of_element[e] = slot + (i - first);
        model.element_of_slot[slot + (i - first)] = e;
        ordered[first_element + i] = model.mesh.hexahedra[e];
      }
      if (!levels.own.empty()) model.tile_levels[first_tile + t] = {group.level, own};
    });
  }
  model.tile_colours = colour_tiles(tile_elements, ordered, model.mesh.nodes.size());
  return ordered;
}

/// Limits of materials that have some; one may be a part of the smallest stable step.
template <class S>
void set_failure_limits(Model<S>& model, const ElementParts& parts, const std::vector<double>& mass_factor) {
  const auto& materials = model.scene.materials;
  const bool any =
      std::ranges::any_of(materials, [](const Material& m) { return m.erosion && m.erosion->step_share > 0; });
  const double smallest = any ? smallest_stable_step(model.scene, model.mesh, parts, mass_factor) : 0;
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    const Material& material = materials[model.parts[p].material];
    model.constants[p].failure.limits = failure_limits<S>(material, smallest);
    if (p < model.single_constants.size()) {
      model.single_constants[p].failure.limits = failure_limits<float>(material, smallest);
    }
  }
}

template <class S>
void fill_nodes(Model<S>& model) {
  model.nodes = NodeStore<S>(model.mesh.nodes.size());
  parallel_for("places of nodes", RangePolicy<>{0, std::ssize(model.mesh.nodes)}, [&](std::int64_t n) {
    const std::int32_t node = model.node_of_scene_node[n];
    S* const position = model.nodes.position_of(node);
    for (std::size_t k = 0; k < 3; ++k) position[k] = static_cast<S>(model.mesh.nodes[n][k]);
    model.nodes.velocity_of(node)[0] = S(0);  // so that its pages come here, and not where one thread works
  });
}

/// The share that the element of a slot gives the node of its corner i.
template <class S>
void add_node_mass(Model<S>& model, std::int64_t slot, int i, double share) {
  const std::int32_t e = model.element_of_slot[slot], node = model.elements.corner[model.elements.at(slot, i, 8)];
  model.node_mass[node] += model.element_mass[e] * share;
  if (!model.added_mass.empty()) model.added_node_mass[node] += model.added_mass[e] * share;
}

/// Of each tile the number of the first node that no tile before it touches: nodes are numbered as tiles touch them
/// first.
template <class S>
std::vector<std::int32_t> first_nodes_of_tiles(const Model<S>& model) {
  const std::int64_t tiles = std::ssize(model.tile_packs) - 1, row = 8 * model.elements.width;
  std::vector<std::int32_t> first(tiles + 1, 0);
  parallel_for("nodes of tiles", RangePolicy<>{0, tiles}, [&](std::int64_t tile) {
    const std::int32_t* const corner = model.elements.corner.data();
    first[tile + 1] =
        1 + *std::max_element(corner + row * model.tile_packs[tile], corner + row * model.tile_packs[tile + 1]);
  });
  for (std::int64_t tile = 0; tile < tiles; ++tile) first[tile + 1] = std::max(first[tile], first[tile + 1]);
  return first;
}

/// In the order of the slots. To a node the tile that touches it first gives first: so all threads add what tiles give
/// to such nodes of their own, and then what they give to those of others follows, tile after tile.
template <class S>
void add_node_masses(Model<S>& model) {
  struct Corner {
    std::int64_t slot;
    int i;
    double share;
  };
  const std::vector<std::int32_t> first = first_nodes_of_tiles(model);
  const std::int64_t tiles = std::ssize(model.tile_packs) - 1, W = model.elements.width;
  std::vector<std::vector<Corner>> at_others(tiles);
  parallel_for("masses of nodes", RangePolicy<>{0, tiles}, [&](std::int64_t tile) {
    for (std::int64_t slot = W * model.tile_packs[tile]; slot < W * model.tile_packs[tile + 1]; ++slot) {
      if (model.is_padding(slot)) continue;
      const CornerShares share = corner_shares(model.scene, model.mesh, model.element_of_slot[slot]);
      for (int i = 0; i < 8; ++i) {
        if (model.elements.corner[model.elements.at(slot, i, 8)] < first[tile]) {
          at_others[tile].push_back({slot, i, share[i]});
        } else {
          add_node_mass(model, slot, i, share[i]);
        }
      }
    }
  });
  for (const std::vector<Corner>& corners : at_others) {
    for (const Corner& corner : corners) add_node_mass(model, corner.slot, corner.i, corner.share);
  }
}

/// Corners and masses of the elements, and the masses of the nodes: their shares of their elements. mass_factor: of
/// what a material gives, per element; empty: 1. onset: as of folding_onsets().
template <class S>
void fill_elements(Model<S>& model, const ElementStoreFeatures& features, const std::vector<double>& mass_factor,
                   const std::vector<double>& onset) {
  model.elements = ElementStore(model.tile_packs.back(), features, has_single_elements<S>(model.scene));
  model.element_mass.resize(model.mesh.hexahedra.size());
  model.added_mass.resize(mass_factor.size());
  model.added_node_mass.assign(mass_factor.empty() ? 0 : model.mesh.nodes.size(), 0.0);
  model.node_mass.assign(model.mesh.nodes.size(), 0.0);
  std::vector<double> density_of_body;
  for (const std::size_t material : material_of_bodies(model.scene)) {
    density_of_body.push_back(model.scene.materials[material].density);
  }
  parallel_for("masses of elements", RangePolicy<>{0, model.mesh.element_count()}, [&](std::int64_t element) {
    model.element_mass[element] = density_of_body[model.mesh.body[element]] * element_volume(model.mesh, element);
  });
  parallel_for("elements of slots", RangePolicy<>{0, model.elements.slots}, [&](std::int64_t slot) {
    std::int64_t filled = slot;  // of padding: that of the element before it
    while (model.is_padding(filled)) --filled;
    const std::int32_t e = model.element_of_slot[filled];
    for (int i = 0; i < 8; ++i) {
      model.elements.corner[model.elements.at(slot, i, 8)] = model.node_of_scene_node[model.mesh.hexahedra[e][i]];
    }
    if (filled != slot) return;
    model.elements.mass[slot] = model.element_mass[e];
    if (!mass_factor.empty()) {
      model.added_mass[e] = (mass_factor[e] - 1) * model.element_mass[e];
      model.element_mass[e] += model.added_mass[e];
      model.elements.mass_share[slot] = 1 / mass_factor[e];
    }
    if (!onset.empty()) model.elements.folding_onset[slot] = onset[e];
    if (!features.volume_ratio) return;
    for (const int of_step : {0, 1}) model.elements.volume_ratio[model.elements.at(slot, of_step, 2)] = 1;
  });
  add_node_masses(model);
}

template <class S>
void invert_node_masses(Model<S>& model) {
  const std::int64_t count = std::ssize(model.node_mass);
  const std::int64_t bad = first_where("inverse masses", count, [&](std::int64_t n) {
    const S inverse = model.nodes.inverse_mass[n] = static_cast<S>(1.0 / model.node_mass[n]);
    return !(inverse > S(0)) || !std::isfinite(inverse);
  });
  if (bad == count) return;
  throw InputError(
      fmt::format("{}a node has the mass {:.6g}, which {} precision cannot divide by: expected another density, "
                  "size of elements or unit of mass",
                  message_head(model.scene), model.node_mass[bad], sizeof(S) == sizeof(double) ? "double" : "single"));
}

/// From the numbers of the scene to those of the stores.
template <class S>
void number_ties(Model<S>& model) {
  for (TiedNode& tied : model.tied_nodes) {
    tied.node = model.node_of_scene_node[tied.node];
    for (std::int32_t& corner : tied.corner) corner = model.node_of_scene_node[corner];
    tied.slot = model.slot_of_element[tied.slot];
  }
  std::sort(model.tied_nodes.begin(), model.tied_nodes.end(),
            [](const TiedNode& a, const TiedNode& b) { return a.node < b.node; });
}

/// Nodes that are tied go to their faces, and what overlaps apart, where that is asked for.
template <class S>
void move_to_start(Model<S>& model) {
  const auto tell = [&model](std::string sentence) {
    if (!sentence.empty()) model.mesh.warnings.push_back(std::move(sentence));
  };
  std::optional<MovedNodes> moved;
  if (model.scene.contact.overlap == ContactOverlap::adjust || !model.scene.tied_contacts.empty()) {
    moved.emplace(model.mesh);
  }
  model.tied_nodes = find_ties(model.scene, model.mesh, model.tie_counts);
  if (moved) tell(moved->take(model.mesh, "contact.tied"));
  for (std::string& sentence : find_tied_at_walls(model.scene, model.mesh, model.tied_nodes)) tell(std::move(sentence));
  model.look = look_at(model.scene, model.mesh);
  adjust_initial_overlaps(model.scene, model.tied_nodes, model.mesh);
  if (moved) tell(moved->take(model.mesh, "contact.overlap = \"adjust\""));
}

}  // namespace

std::vector<std::size_t> material_of_bodies(const Scene& scene) {
  std::unordered_map<std::string_view, std::size_t> numbers;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) numbers.try_emplace(scene.materials[m].name, m);
  std::vector<std::size_t> materials;
  for (const Body& body : scene.bodies) {
    const auto found = numbers.find(body.material);
    if (found == numbers.end()) {
      throw InputError(fmt::format("{}no material named {}", message_head(scene), body.material));
    }
    materials.push_back(found->second);
  }
  return materials;
}

template <class S>
void Model<S>::persist(StateArchive& archive) {
  for (Array<S>* array : {&nodes.position, &nodes.velocity}) {
    std::span<S> of_nodes(array->data(), 4 * static_cast<std::size_t>(nodes.count));
    archive.of_fixed_size(of_nodes);
  }
  for (RealArray* array : elements.state()) archive.of_fixed_size(*array);
  for (std::int64_t slot = 0; archive.reads() && slot < elements.slots; ++slot) {
    archive.require(!is_padding(slot) || !elements.alive(slot));
  }
}

template <class S>
std::size_t Model<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return nodes.bytes() + elements.bytes() + of(mesh.nodes) + of(mesh.hexahedra) + of(mesh.body) +
         of(mesh.body_of_node) + of(constraints) + of(prescribed) + of(element_of_slot) + of(slot_of_element) +
         of(node_of_scene_node) + of(element_mass) + of(added_mass) + of(node_mass) + of(added_node_mass) +
         of(point_mass);
}

template <class S>
Model<S> build_model(const Scene& given) {
  Model<S> model;
  model.scene = given;
  complete_scene(model.scene);
  model.mesh = build_mesh(model.scene);
  for (Body& body : model.scene.bodies) {
    if (std::holds_alternative<ArrayMesh>(body.mesh)) body.mesh = ArrayMesh{};  // the host's arrays may go now
  }
  move_to_start(model);
  model.rigid_of_body = rigid_body_of_bodies(model.scene);
  model.rigid = find_rigid_nodes(model.scene, model.mesh, model.tied_nodes);
  set_given_masses(model.scene, model.mesh);
  const ElementParts parts = element_parts(model.scene, model.mesh);
  ElementStoreFeatures features = add_parts(model, parts);
  const std::vector<double> mass_factor = mass_factors(model.scene, model.mesh, parts);
  features.mass_share = !mass_factor.empty();
  set_failure_limits(model, parts, mass_factor);
  const std::vector<double> onset = folding_onsets(model.mesh);
  features.folding_onset = !onset.empty();
  const std::int32_t node_count = model.mesh.nodes.size();
  model.node_of_scene_node =
      inverse_permutation(first_touch_node_order(add_tiles(model, parts, mass_factor), node_count));
  fill_nodes(model);
  fill_elements(model, features, mass_factor, onset);
  add_point_masses(model);
  invert_node_masses(model);
  number_ties(model);
  number_rigid_nodes(model.rigid, model.node_of_scene_node);
  set_constraints(model, 0);
  set_initial_velocities(model);
  set_initial_stresses(model);
  const std::vector<std::string> left_out = find_left_out(model.scene, model.mesh);
  model.mesh.warnings.insert(model.mesh.warnings.end(), left_out.begin(), left_out.end());
  return model;
}

template struct Model<double>;
template struct Model<float>;
template Model<double> build_model<double>(const Scene&);
template Model<float> build_model<float>(const Scene&);

}  // namespace pinball
