#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include <solver/base/error.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/base/point.hpp>
#include <solver/formats/mesh_reader.hpp>
#include <solver/mesh/array_mesh.hpp>
#include <solver/mesh/generators.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/shapes/wedges.hpp>
#include <solver/mesh/tetrahedra.hpp>
#include <solver/model/checks/file_checks.hpp>
#include <solver/model/interfaces/contact_sides.hpp>
#include <solver/model/selection/file_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>

#include "element_checks.hpp"
#include "model.hpp"

namespace pinball {

double element_volume(const ModelMesh& mesh, std::size_t element) {
  return volume_by_quadrature(mesh.corners(element));
}

Point element_centre(const ModelMesh& mesh, std::size_t element) {
  Point centre{};
  for (const Point& corner : mesh.corners(element)) {
    for (std::size_t k = 0; k < 3; ++k) centre[k] += corner[k] / 8;
  }
  return centre;
}

Point element_extent(const ModelMesh& mesh, std::size_t element) {
  Point low = mesh.corner(element, 0), high = low;
  for (const Point& corner : mesh.corners(element)) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corner[k]);
      high[k] = std::max(high[k], corner[k]);
    }
  }
  return {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
}

namespace {

/// Files and generators name what is wrong; of arrays only the scene knows to which body they belong.
Mesh mesh_of(const Body& body) {
  const auto* arrays = std::get_if<ArrayMesh>(&body.mesh);
  const bool cut = body.elements == ElementShape::tetrahedra;
  if (arrays == nullptr) return cut ? cut_into_tetrahedra(generate(body.mesh)) : generate(body.mesh);
  try {
    Mesh mesh = copy_mesh(*arrays);
    for (Corners8& corners : mesh.hexahedra) corners = as_tetrahedron(corners).value_or(corners);
    return cut ? cut_into_tetrahedra(mesh) : mesh;
  } catch (const InputError& error) {
    throw InputError(fmt::format("body.{}.{}", body.name, error.what()));
  }
}

bool same_file(const Body& a, const Body& b) {
  const auto* mine = std::get_if<FileMesh>(&a.mesh);
  const auto* other = std::get_if<FileMesh>(&b.mesh);
  return mine != nullptr && other != nullptr && mine->file == other->file && mine->format == other->format &&
         mine->chosen_case == other->chosen_case && mine->scale == other->scale && mine->array == other->array &&
         mine->splits == other->splits && a.axis == b.axis && a.position == b.position;
}

/// Puts the meshes of the bodies together.
class Assembly {
 public:
  explicit Assembly(const Scene& scene) : scene_(scene), file_of_body_(scene.bodies.size(), -1) {}

  ModelMesh build() {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
      all_.body_names.push_back(scene_.bodies[b].name);
      all_.shared.emplace_back();
      if (std::holds_alternative<FileMesh>(scene_.bodies[b].mesh)) {
        add_part(b);
      } else {
        add_mesh(b);
      }
    }
    for (const Placed& placed : files_) {
      all_.files.push_back(file_nodes(placed.file, placed.node, placed.element));
    }
    check_files();
    all_.file_of_body = file_of_body_;
    find_edges();
    return std::move(all_);
  }

 private:
  /// A file at its place, and which of its nodes the model has by now.
  struct Placed {
    MeshFile file;
    std::vector<std::int32_t> node;     ///< of the model, per node of the file; -1: none
    std::vector<std::int32_t> element;  ///< of the model, per element of the file; -1: none
    std::unordered_map<std::string, std::vector<std::int32_t>> of_part{};  ///< elements of those that have a name alone

    /// Those of many parts are found in one go through the file, where a name, or a number, is that of one part alone.
    void find_parts() {
      std::map<std::string, int> uses;
      std::vector<std::string> names;
      for (const MeshPart& part : file.parts) {
        names.push_back(part.id != 0 ? std::to_string(part.id) : part.name);
        ++uses[names.back()];
        if (part.id != 0 && part.name != names.back()) ++uses[part.name];
      }
      for (std::size_t e = 0; e < file.part.size(); ++e) {
        if (file.part[e] < 0) continue;
        const std::string& name = names[file.part[e]];
        if (!name.empty() && uses[name] == 1) of_part[name].push_back(e);
      }
    }
    std::vector<std::int32_t> elements_of(const std::string& part) const {
      const auto found = of_part.find(part);
      return found != of_part.end() ? found->second : elements_of_part(file, part);
    }
  };

  void add_mesh(std::size_t b) {
    Mesh mesh = mesh_of(scene_.bodies[b]);
    check_volumes(mesh, b);
    place_of_body(mesh, b);
    const std::int32_t offset = add_nodes(mesh.nodes.size(), b);
    const bool is_first = all_.nodes.empty();  // its memory is taken, not copied
    if (is_first) {
      all_.nodes = std::move(mesh.nodes);
    } else {
      all_.nodes.insert(all_.nodes.end(), mesh.nodes.begin(), mesh.nodes.end());
    }
    const std::int64_t first = all_.element_count(), count = std::ssize(mesh.hexahedra);
    const bool given = std::holds_alternative<ArrayMesh>(scene_.bodies[b].mesh);
    all_.body.insert(all_.body.end(), count, static_cast<std::int32_t>(b));
    if (is_first) {
      all_.hexahedra = std::move(mesh.hexahedra);
    } else {
      all_.hexahedra.insert(all_.hexahedra.end(), mesh.hexahedra.begin(), mesh.hexahedra.end());
    }
    const auto problem = [&](std::int64_t e) { return rounding_problem(all_.corners(e), scene_.precision); };
    parallel_for("elements of a body", RangePolicy<>{0, count}, [&](std::int64_t e) {
      std::array<std::int32_t, 8>& hexahedron = all_.hexahedra[first + e];
      for (std::int32_t& node : hexahedron) node += offset;
      if (given) turn(hexahedron);
    });
    const std::int64_t bad =
        first_where("rounding of volumes", count, [&](std::int64_t e) { return !problem(first + e).empty(); });
    if (bad < count) require_none(problem(first + bad), b, [&] { return fmt::format("element {}", first + bad); });
  }

  /// Of a file or a host: the order in which nodes of a wedge are listed does not count.
  void turn(Corners8& corners) const {
    if (const auto wedge = as_wedge(corners)) corners = turned_wedge(*wedge, all_.nodes);
  }

  /// In the body's own frame, where no place far away hides what the shape is.
  void check_volumes(const Mesh& mesh, std::size_t b) const {
    const auto problem = [&](std::int64_t e) {
      std::array<Point, 8> corners;
      for (std::size_t i = 0; i < 8; ++i) corners[i] = mesh.nodes[mesh.hexahedra[e][i]];
      return volume_problem(corners, scene_.precision);
    };
    const std::int64_t count = std::ssize(mesh.hexahedra);
    const std::int64_t bad = first_where("volumes", count, [&](std::int64_t e) { return !problem(e).empty(); });
    if (bad < count)
      require_none(problem(bad), b, [&] { return fmt::format("element {}", all_.element_count() + bad); });
  }

  template <class Name>
  void require_none(const std::string& problem, std::size_t b, const Name& name) const {
    if (problem.empty()) return;
    throw InputError(fmt::format("{}body {}: {} {}", message_head(scene_), scene_.bodies[b].name, name(), problem));
  }

  void place_of_body(Mesh& mesh, std::size_t b) const {
    try {
      place(mesh, scene_.bodies[b].axis, scene_.bodies[b].position);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}body {}: {}", message_head(scene_), scene_.bodies[b].name, error.what()));
    }
  }

  /// Number of the first of so many new nodes.
  std::int32_t add_nodes(std::size_t count, std::size_t b) {
    if (all_.nodes.size() + count > 2'000'000'000 / 4) {
      throw InputError(
          fmt::format("{}body {}: more than 500 million nodes", message_head(scene_), scene_.bodies[b].name));
    }
    all_.body_of_node.insert(all_.body_of_node.end(), count, b);
    return all_.nodes.size();
  }

  template <class Name>
  void add_element(const std::array<std::int32_t, 8>& hexahedron, std::size_t b, const Name& name) {
    all_.hexahedra.push_back(hexahedron);
    all_.body.push_back(b);
    require_none(rounding_problem(all_.corners(all_.element_count() - 1), scene_.precision), b, name);
  }

  Placed& file_of(std::size_t b) {
    const auto* settings = std::get_if<FileMesh>(&scene_.bodies[b].mesh);
    std::vector<std::string> parts;
    for (std::size_t other = 0; other < scene_.bodies.size(); ++other) {
      if (!same_file(scene_.bodies[other], scene_.bodies[b])) continue;
      if (other < b) return files_[file_of_body_[b] = file_of_body_[other]];
      parts.push_back(std::get_if<FileMesh>(&scene_.bodies[other].mesh)->part);
    }
    file_of_body_[b] = files_.size();
    Placed placed{read_mesh_file(*settings, parts), {}, {}, {}};
    place_of_body(placed.file.mesh, b);
    placed.node.assign(placed.file.mesh.nodes.size(), -1);
    placed.element.assign(placed.file.mesh.hexahedra.size(), -1);
    if (parts.size() > 1) placed.find_parts();
    return files_.emplace_back(std::move(placed));
  }

  /// The nodes that the part has to itself are new, in the order of the file.
  void add_part(std::size_t b) {
    if (scene_.bodies[b].elements != ElementShape::hexahedra) {
      throw InputError(
          fmt::format("{}body {}: elements: expected a mesh that is generated, elements of a file are "
                      "what they are there",
                      message_head(scene_), scene_.bodies[b].name));
    }
    Placed& placed = file_of(b);
    const MeshFile& file = placed.file;
    const std::vector<std::int32_t> elements = placed.elements_of(std::get_if<FileMesh>(&scene_.bodies[b].mesh)->part);
    if (elements.empty()) {
      throw InputError(
          fmt::format("{}body {}: {} has no hexahedra of it", message_head(scene_), scene_.bodies[b].name, file.path));
    }
    for (const std::int32_t e : elements) require_free(placed, e, b);
    for (const std::int32_t n : nodes_of(file, elements)) {
      if (placed.node[n] >= 0) {
        all_.shared[b].push_back(placed.node[n]);
        continue;
      }
      placed.node[n] = add_nodes(1, b);
      all_.nodes.push_back(file.mesh.nodes[n]);
    }
    std::sort(all_.shared[b].begin(), all_.shared[b].end());
    for (const std::int32_t e : elements) {
      std::array<std::int32_t, 8> hexahedron = file.mesh.hexahedra[e];
      for (std::int32_t& node : hexahedron) node = placed.node[node];
      require_none(volume_problem(all_.corners_of(hexahedron), scene_.precision), b,
                   [&] { return element_name(file, e); });
      placed.element[e] = all_.element_count();
      turn(hexahedron);
      add_element(hexahedron, b, [&] { return element_name(file, e); });
    }
  }

  /// Of some elements, in the order of the file.
  static std::vector<std::int32_t> nodes_of(const MeshFile& file, const std::vector<std::int32_t>& elements) {
    std::vector<std::int32_t> nodes;
    for (const std::int32_t e : elements)
      nodes.insert(nodes.end(), file.mesh.hexahedra[e].begin(), file.mesh.hexahedra[e].end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  void require_free(const Placed& placed, std::int32_t e, std::size_t b) const {
    if (placed.element[e] < 0) return;
    throw InputError(fmt::format("{}body {}: {} belongs to body {}, too", message_head(scene_), scene_.bodies[b].name,
                                 element_name(placed.file, e), all_.body_of_element(placed.element[e])));
  }

  /// Per element of the file; -1: none.
  std::vector<std::int32_t> bodies_of(const Placed& placed) const {
    std::vector<std::int32_t> bodies = placed.element;
    for (std::int32_t& element : bodies) element = element < 0 ? -1 : all_.body[element];
    return bodies;
  }

  void check_files() {
    if (files_.empty()) return;
    const MetSides sides(scene_, all_);
    for (const Placed& placed : files_) {
      const auto may_meet = [&](std::int32_t a, std::int32_t b) { return sides.have(placed.node[a], placed.node[b]); };
      const auto warnings = check_file(placed.file, bodies_of(placed), all_.body_names, may_meet);
      all_.warnings.insert(all_.warnings.end(), warnings.begin(), warnings.end());
    }
  }

  /// By which selections know how far from a plane its nodes may be.
  void find_edges() {
    if (!selects_by_place(scene_)) return;
    all_.edge.assign(all_.nodes.size(), std::numeric_limits<float>::max());
    for (const auto& hexahedron : all_.hexahedra) {
      for (const auto& [first, second] : edges_of_hexahedron) {
        const std::int32_t a = hexahedron[first], b = hexahedron[second];
        if (a == b) continue;  // collapsed
        const auto length = static_cast<float>(norm(minus(all_.nodes[a], all_.nodes[b])));
        all_.edge[a] = std::min(all_.edge[a], length);
        all_.edge[b] = std::min(all_.edge[b], length);
      }
    }
  }

  const Scene& scene_;
  ModelMesh all_;
  std::vector<Placed> files_;
  std::vector<std::int32_t> file_of_body_;
};

}  // namespace

std::string message_head(const Scene& scene) { return scene.path.empty() ? "" : scene.path + ": "; }

ModelMesh build_mesh(const Scene& scene) { return Assembly(scene).build(); }

}  // namespace pinball
