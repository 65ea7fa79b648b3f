#include "exodus_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>

#include "netcdf_file.hpp"

/// Format: L. A. Schoof, V. R. Yarberry, "EXODUS II: A Finite Element Data Model", SAND92-2137, and the names of
/// variables of the library that writes it (exodusII.h of SEACAS).
namespace pinball {
namespace {

const ElementType* type_of(const std::string& form, std::int64_t nodes) {
  for (const ElementType& type : element_types()) {
    if (!type.exodus.empty() && form.starts_with(type.exodus) && type.nodes == nodes) return &type;
  }
  return nullptr;
}

/// "HEX8, WEDGE6, PYRAMID5, TET4 or TET10"
std::string names_of_blocks() {
  std::vector<std::string> names;
  for (const ElementType& type : element_types()) {
    if (!type.exodus.empty()) names.push_back(fmt::format("{}{}", type.exodus, type.nodes));
  }
  return fmt::format("{} or {}", fmt::join(names.begin(), names.end() - 1, ", "), names.back());
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Elements without a volume by the beginnings of their names.
bool is_without_volume(const std::string& type) {
  const std::string name = upper(type);
  return std::ranges::any_of(std::vector<std::string>{"SHELL", "QUAD", "TRI", "BAR", "BEAM", "TRUSS", "ROD", "EDGE",
                                                      "SPHERE", "CIRCLE", "POINT", "SPRING", "NSIDED", "MEMBRANE"},
                             [&](const std::string& beginning) { return name.starts_with(beginning); });
}

class ExodusReader {
 public:
  ExodusReader(const std::string& path, const std::vector<std::string>& parts) : in_(path), wanted_(parts) {}

  MeshFile read() {
    file_.path = in_.path();
    if (in_.dimension("num_dim") != 3) fail("expected an Exodus mesh of three dimensions");
    read_nodes();
    const Names blocks = names_of("eb", in_.dimension("num_el_blk"));
    for (std::size_t b = 0; b < blocks.ids.size(); ++b) read_block(b, blocks);
    read_element_numbers();
    read_node_sets();
    read_side_sets();
    read_element_sets();
    if (file_.mesh.hexahedra.empty()) fail(fmt::format("expected blocks of {}, got none", names_of_shapes()));
    return std::move(file_);
  }

 private:
  struct Names {
    std::vector<std::int64_t> ids;
    std::vector<std::string> names;
  };

  [[noreturn]] void fail(const std::string& problem) const { throw InputError(file_.path + ": " + problem); }

  /// Numbers and names of blocks (eb) or sets (ns, ss, els): 1, 2, ... and none where the file has none.
  Names names_of(const std::string& kind, std::int64_t count) const {
    Names names;
    const std::string property = kind + "_prop1", text = kind + "_names";
    if (in_.has(property)) names.ids = in_.integers(property);
    if (count > 1'000'000 || (!names.ids.empty() && std::ssize(names.ids) != count))
      in_.fail(property, fmt::format("expected {} numbers, got {}", count, names.ids.size()));
    for (std::int64_t i = 0; std::ssize(names.ids) < count; ++i) names.ids.push_back(i + 1);
    if (in_.has(text)) names.names = in_.texts(text);
    names.names.resize(names.ids.size());
    return names;
  }

  void read_nodes() {
    const std::int64_t count = in_.dimension("num_nodes");
    if (count > std::numeric_limits<std::int32_t>::max())
      fail(fmt::format("{} nodes are more than a mesh can hold", count));
    std::vector<double> all;
    const bool together = !in_.has("coordx") && in_.has("coord");
    if (together) all = in_.numbers("coord");
    if (together && std::ssize(all) != 3 * count)
      in_.fail("coord", fmt::format("expected {} numbers, got {}", 3 * count, all.size()));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string name = together ? "coord" : std::string("coord") + "xyz"[k];
      const std::vector<double> one = together ? std::vector<double>() : in_.numbers(name);
      if (!together && std::ssize(one) != count)
        in_.fail(name, fmt::format("expected {} numbers, got {}", count, one.size()));
      file_.mesh.nodes.resize(count);
      const double* const values = together ? all.data() + k * count : one.data();
      for (std::int64_t n = 0; n < count; ++n) {
        if (!std::isfinite(values[n]))
          in_.fail(name, fmt::format("expected numbers, got {} for node {}", values[n], n + 1));
        file_.mesh.nodes[n][k] = values[n];
      }
    }
    file_.node_ids = numbers("node_num_map", count);
  }

  /// The map of that name, or 1, 2, 3, ...
  std::vector<std::int64_t> numbers(const std::string& map, std::int64_t count) const {
    if (in_.has(map)) {
      std::vector<std::int64_t> ids = in_.integers(map);
      if (std::ssize(ids) != count) in_.fail(map, fmt::format("expected {} numbers, got {}", count, ids.size()));
      return ids;
    }
    std::vector<std::int64_t> ids(count);
    for (std::int64_t i = 0; i < count; ++i) ids[i] = i + 1;
    return ids;
  }

  bool is_needed(std::int64_t id, const std::string& name) const {
    return wanted_.empty() || std::ranges::any_of(wanted_, [&](const std::string& part) {
             return part == name || part == std::to_string(id);
           });
  }

  void read_block(std::size_t b, const Names& blocks) {
    const std::string number = std::to_string(b + 1), variable = "connect" + number;
    const std::int64_t count = in_.dimension("num_el_in_blk" + number);
    if (count == 0) return;
    const std::vector<std::int64_t> shape = in_.shape(variable);
    if (shape.size() != 2 || shape[0] != count || shape[1] < 1)
      in_.fail(variable, fmt::format("expected the nodes of {} elements", count));
    const std::string type = in_.attribute(variable, "elem_type");
    const ElementType* const form = type_of(upper(type), shape[1]);
    if (form == nullptr) return reject(blocks, b, type, shape[1], count);
    const std::int32_t first = file_.mesh.hexahedra.size();
    if (first + count > std::numeric_limits<std::int32_t>::max() / 8) fail("has more elements than a mesh can hold");
    for (std::int64_t e = 0; e < count; ++e) place_.push_back(first + e);
    file_.mesh.hexahedra.reserve(first + count);
    if (form->shape == SolidShape::hexahedron && form->nodes == 8) {  // as they lie in the file, without a copy
      file_.mesh.hexahedra.resize(first + count);
      read_places(variable, 8, {file_.mesh.hexahedra[first].data(), static_cast<std::size_t>(8 * count)});
    } else {
      std::vector<std::int32_t> nodes(form->nodes * count);
      read_places(variable, form->nodes, nodes);
      for (std::int64_t e = 0; e < count; ++e)
        append_element(file_, *form, std::span(nodes).subspan(e * form->nodes, form->nodes));
    }
    shape_.resize(first + count, form->shape);
    file_.part.resize(first + count, file_.parts.size());
    file_.parts.push_back({blocks.ids[b], blocks.names[b]});
  }

  /// Of nodes, so many of each element.
  void read_places(const std::string& variable, std::int64_t of_each, std::span<std::int32_t> nodes) const {
    in_.integers_into(variable, nodes.data());
    for (std::int64_t i = 0; i < std::ssize(nodes); ++i) {
      if (nodes[i] < 1 || nodes[i] > std::ssize(file_.mesh.nodes))
        in_.fail(variable, fmt::format("element {}: expected nodes from 1 to {}, got {}", i / of_each + 1,
                                       file_.mesh.nodes.size(), nodes[i]));
      --nodes[i];
    }
  }

  void reject(const Names& blocks, std::size_t b, const std::string& type, std::int64_t nodes, std::int64_t count) {
    const std::string what =
        fmt::format("block {}{} has {} of type {} with {}", blocks.ids[b],
                    blocks.names[b].empty() ? "" : " (" + blocks.names[b] + ")", counted(count, "element"),
                    type.empty() ? "unknown" : type, counted(nodes, "node"));
    if (wanted_.empty() ? !is_without_volume(type) : is_needed(blocks.ids[b], blocks.names[b]))
      fail(what + ": expected " + names_of_blocks());
    file_.notes.push_back(fmt::format("{}: {}: left out", file_.path, what));
    place_.insert(place_.end(), count, -1);
  }

  /// Blocks that were left out have numbers, too.
  void read_element_numbers() {
    const std::int64_t count = place_.size();
    if (count != in_.dimension("num_elem"))
      fail(fmt::format("expected {} elements in the blocks, got {}", in_.dimension("num_elem"), count));
    const std::vector<std::int64_t> ids = numbers("elem_num_map", count);
    for (std::int64_t e = 0; e < count; ++e) {
      if (place_[e] >= 0) file_.element_ids.push_back(ids[e]);
    }
  }

  void read_node_sets() {
    const Names sets = names_of("ns", in_.dimension("num_node_sets"));
    for (std::size_t s = 0; s < sets.ids.size(); ++s) {
      const std::string variable = "node_ns" + std::to_string(s + 1);
      MeshSet set{sets.ids[s], sets.names[s], {}};
      const std::int64_t nodes = file_.mesh.nodes.size();
      for (const std::int64_t node : members(variable, "num_nod_ns" + std::to_string(s + 1))) {
        if (node < 1 || node > nodes)
          in_.fail(variable, fmt::format("expected nodes from 1 to {}, got {}", nodes, node));
        set.members.push_back(node - 1);
      }
      file_.node_sets.push_back(std::move(set));
    }
  }

  /// Sets may be empty, and have no variable then.
  std::vector<std::int64_t> members(const std::string& variable, const std::string& dimension) const {
    if (in_.dimension(dimension) == 0) return {};
    return in_.integers(variable);
  }

  /// Place of an element; -1: of a block that was left out.
  std::int32_t place_of(const std::string& variable, std::int64_t element) const {
    if (element < 1 || element > std::ssize(place_))
      in_.fail(variable, fmt::format("expected elements from 1 to {}, got {}", place_.size(), element));
    return place_[element - 1];
  }

  void read_side_sets() {
    const Names sets = names_of("ss", in_.dimension("num_side_sets"));
    std::vector<MeshSet> of_nodes;
    const EdgeMiddles middles(file_);
    for (std::size_t s = 0; s < sets.ids.size(); ++s) {
      const std::string number = std::to_string(s + 1), variable = "side_ss" + number;
      const std::vector<std::int64_t> elements = members("elem_ss" + number, "num_side_ss" + number),
                                      sides = members(variable, "num_side_ss" + number);
      if (elements.size() != sides.size())
        in_.fail(variable, fmt::format("expected {} sides, got {}", elements.size(), sides.size()));
      FaceSet set{sets.ids[s], sets.names[s], {}};
      for (std::size_t i = 0; i < sides.size(); ++i)
        add_side(set, variable, place_of("elem_ss" + number, elements[i]), sides[i]);
      of_nodes.push_back({set.id, set.name, middles.nodes_of(set.faces)});
      file_.face_sets.push_back(std::move(set));
    }
    // Before those that are sets of nodes in the file, which count where both have one number.
    file_.node_sets.insert(file_.node_sets.begin(), of_nodes.begin(), of_nodes.end());
  }

  void add_side(FaceSet& set, const std::string& variable, std::int32_t place, std::int64_t side) const {
    if (place < 0) {
      set.faces.push_back({-1, -1, -1, -1});
      return;
    }
    const auto& sides = known_shape(shape_[place]).exodus_sides;
    const std::int64_t most = std::ranges::count_if(sides, [](const auto& one) { return one[0] >= 0; });
    if (side < 1 || side > most) in_.fail(variable, fmt::format("expected sides from 1 to {}, got {}", most, side));
    const auto& corners = file_.mesh.hexahedra[place];
    std::array<std::int32_t, 4> face;
    for (std::size_t i = 0; i < 4; ++i) face[i] = corners[sides[side - 1][i]];
    set.faces.push_back(face);
  }

  void read_element_sets() {
    const Names sets = names_of("els", in_.dimension("num_elem_sets"));
    for (std::size_t s = 0; s < sets.ids.size(); ++s) {
      const std::string variable = "elem_els" + std::to_string(s + 1);
      MeshSet set{sets.ids[s], sets.names[s], {}};
      for (const std::int64_t element : members(variable, "num_ele_els" + std::to_string(s + 1))) {
        if (const std::int32_t place = place_of(variable, element); place >= 0) set.members.push_back(place);
      }
      std::sort(set.members.begin(), set.members.end());
      set.members.erase(std::unique(set.members.begin(), set.members.end()), set.members.end());
      file_.element_sets.push_back(std::move(set));
    }
  }

  NetcdfFile in_;
  const std::vector<std::string>& wanted_;
  MeshFile file_;
  std::vector<std::int32_t> place_;  ///< per element of the file; -1: left out
  std::vector<SolidShape> shape_;    ///< per hexahedron
};

}  // namespace

MeshFile read_exodus(const std::string& path, const std::vector<std::string>& parts) {
  MeshFile file = ExodusReader(path, parts).read();
  file.sources = {{path, hash_of_file(path)}};  // whose bytes the library has read
  return file;
}

}  // namespace pinball
