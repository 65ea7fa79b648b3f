#include "gmsh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_map>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

#include "gmsh_scanner.hpp"

/// Format: "MSH file format" in the reference manual of Gmsh, versions 2.2 and 4.1.
namespace pinball {
namespace {

constexpr int hexahedron_type = 5, prism_type = 6;

/// A volume element as it stands in the file.
struct Element {
  std::int64_t type;
  std::int64_t volume;    ///< 4.1: tag of its volume entity; 2.2: of its physical group
  std::int64_t nodes[8];  ///< tags, of hexahedra and prisms alone
  int line;
};

/// Whether elements of a type are points, lines or surfaces (2.2, where only the type says so).
bool is_of_lower_dimension(std::int64_t type) {
  return (type >= 1 && type <= 3) || (type >= 8 && type <= 10) || type == 15 || type == 16 ||
         (type >= 20 && type <= 28);
}

std::string type_name(std::int64_t type) {
  static const std::map<std::int64_t, std::string> names{
      {4, "4-node tetrahedra"},  {7, "5-node pyramids"}, {11, "10-node tetrahedra"},
      {12, "27-node hexahedra"}, {13, "18-node prisms"}, {14, "14-node pyramids"},
      {17, "20-node hexahedra"}, {18, "15-node prisms"}, {19, "13-node pyramids"},
  };
  const auto found = names.find(type);
  return found == names.end() ? "elements" : found->second;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : scan_(text, name) {}

  MeshFile read(const std::vector<std::string>& physicals) {
    read_format();
    while (!scan_.at_end()) read_section(std::string(scan_.word("a section such as $Nodes")));
    if (!has_nodes_) scan_.fail("a section $Nodes", "");
    if (!has_elements_) scan_.fail("a section $Elements", "");
    return collect(physicals);
  }

 private:
  void read_format() {
    scan_.keyword("$MeshFormat");
    const std::string version(scan_.word("the format's version"));
    if (version != "2.2" && version != "4.1")
      scan_.fail("format 2.2 or 4.1 (gmsh -format msh41 or msh22 writes them)", version);
    is_4_ = version == "4.1";
    const std::int64_t binary = scan_.integer("0 for a text file");
    if (binary != 0) scan_.fail("0 for a text file (gmsh writes one with Mesh.Binary = 0)", std::to_string(binary));
    scan_.count("the size of a number");
    scan_.keyword("$EndMeshFormat");
  }

  void read_section(const std::string& section) {
    if (section.size() < 2 || section[0] != '$') scan_.fail("a section such as $Nodes", section);
    if (section == "$PhysicalNames") {
      read_physical_names();
    } else if (section == "$Entities" && is_4_) {
      read_entities();
    } else if (section == "$Nodes" || (section == "$ParametricNodes" && !is_4_)) {
      has_nodes_ = true;
      is_4_ ? read_node_blocks() : read_nodes(section == "$ParametricNodes");
    } else if (section == "$Elements") {
      has_elements_ = true;
      is_4_ ? read_element_blocks() : read_elements();
    } else {
      const std::string end = "$End" + section.substr(1);
      while (scan_.word(end) != end) {
      }
      return;
    }
    scan_.keyword("$End" + section.substr(1));
  }

  void read_physical_names() {
    const std::int64_t count = scan_.count("the number of physical names");
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t dimension = scan_.count("the dimension of a physical group");
      const std::int64_t tag = scan_.integer("the tag of a physical group");
      const std::string name = scan_.quoted("a physical name in quotes");
      (dimension == 3 ? volume_groups_ : other_groups_).insert({name, tag});
    }
  }

  void read_entities() {
    std::int64_t counts[4];
    for (auto& count : counts) count = scan_.count("a number of points, curves, surfaces or volumes");
    has_entities_ = true;
    for (int dimension = 0; dimension < 4; ++dimension)
      for (std::int64_t i = 0; i < counts[dimension]; ++i) {
        const std::int64_t tag = scan_.integer("the tag of an entity");
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) scan_.number("a bound of an entity");
        const std::int64_t groups = scan_.count("a number of physical groups");
        for (std::int64_t k = 0; k < groups; ++k) {
          const std::int64_t group = std::abs(scan_.integer("the tag of a physical group"));  // its sign: orientation
          if (dimension == 3) groups_of_volume_[tag].insert(group);
        }
        if (dimension == 0) continue;
        const std::int64_t boundaries = scan_.count("a number of bounding entities");
        for (std::int64_t k = 0; k < boundaries; ++k) scan_.integer("the tag of a bounding entity");
      }
  }

  void add_node(std::int64_t tag) {
    if (!node_of_tag_.emplace(tag, nodes_.size()).second) scan_.fail("a node of its own", fmt::format("{} again", tag));
    Point x;
    for (double& coordinate : x) coordinate = scan_.number(fmt::format("a coordinate of node {}", tag));
    nodes_.push_back(x);
  }

  void read_nodes(bool parametric) {
    const std::int64_t count = scan_.count("the number of nodes");
    for (std::int64_t i = 0; i < count; ++i) {
      add_node(scan_.integer("the tag of a node"));
      if (parametric) scan_.skip_line("the entity of a node");
    }
  }

  void read_node_blocks() {
    const std::int64_t blocks = scan_.count("the number of blocks of nodes"),
                       total = scan_.count("the number of nodes");
    for (const auto* bound : {"the smallest", "the largest"}) scan_.integer(fmt::format("{} tag of the nodes", bound));
    for (std::int64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = scan_.count("the dimension of an entity");
      scan_.integer("the tag of an entity");
      const bool parametric = scan_.count("1 if nodes have parametric coordinates, else 0") != 0;
      const std::int64_t count = scan_.count("the number of nodes in the block");
      std::vector<std::int64_t> tags;
      for (std::int64_t i = 0; i < count; ++i) tags.push_back(scan_.integer("the tag of a node"));
      for (const std::int64_t tag : tags) {
        add_node(tag);
        for (std::int64_t k = 0; parametric && k < dimension; ++k) scan_.number("a parametric coordinate");
      }
    }
    if (static_cast<std::int64_t>(nodes_.size()) != total)
      scan_.fail(fmt::format("{} nodes in the blocks", total), std::to_string(nodes_.size()));
  }

  /// The nodes of an element whose type and volume are known.
  void add_element(Element element) {
    element.line = scan_.line();
    const int count = element.type == hexahedron_type ? 8 : element.type == prism_type ? 6 : 0;
    for (int i = 0; i < count; ++i) element.nodes[i] = scan_.integer("a node of an element");
    if (count == 0) scan_.skip_line("the nodes of an element");
    elements_.push_back(element);
  }

  void read_elements() {
    const std::int64_t count = scan_.count("the number of elements");
    for (std::int64_t i = 0; i < count; ++i) {
      scan_.integer("the number of an element");
      const std::int64_t type = scan_.count("the type of an element");
      const std::int64_t tags = scan_.count("the number of tags of an element");
      std::int64_t group = 0;
      for (std::int64_t k = 0; k < tags; ++k) {
        const std::int64_t tag = scan_.integer("a tag of an element");
        if (k == 0) group = tag;
      }
      if (is_of_lower_dimension(type)) {
        scan_.skip_line("the nodes of an element");
      } else {
        add_element({type, group, {}, 0});
      }
    }
  }

  void read_element_blocks() {
    const std::int64_t blocks = scan_.count("the number of blocks of elements");
    scan_.count("the number of elements");
    for (const auto* bound : {"the smallest", "the largest"})
      scan_.integer(fmt::format("{} tag of the elements", bound));
    for (std::int64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = scan_.count("the dimension of an entity");
      const std::int64_t volume = scan_.integer("the tag of an entity");
      const std::int64_t type = scan_.count("the type of the elements");
      const std::int64_t count = scan_.count("the number of elements in the block");
      for (std::int64_t i = 0; i < count; ++i) {
        scan_.integer("the tag of an element");
        if (dimension == 3) {
          add_element({type, volume, {}, 0});
        } else {
          scan_.skip_line("the nodes of an element");
        }
      }
    }
  }

  /// Tag of the physical volume of a name. Throws InputError if there is none.
  std::int64_t group_of(const std::string& name) const {
    const auto found = volume_groups_.find(name);
    if (found != volume_groups_.end()) {
      if (is_4_ && !has_entities_)
        throw InputError(
            fmt::format("{}: expected a section $Entities, which says what \"{}\" is", scan_.name(), name));
      return found->second;
    }
    std::vector<std::string> known;
    for (const auto& group : volume_groups_) known.push_back(group.first);
    std::string hint = "it has none with a name";
    if (!known.empty()) hint = fmt::format("nearest is \"{}\"", nearest(name, known));
    if (other_groups_.contains(name)) hint = "it is a group of surfaces, curves or points; " + hint;
    throw InputError(fmt::format("{}: no physical volume is named \"{}\": {}", scan_.name(), name, hint));
  }

  bool belongs(const Element& element, std::int64_t group) const {
    if (!is_4_) return element.volume == group;
    const auto found = groups_of_volume_.find(element.volume);
    return found != groups_of_volume_.end() && found->second.contains(group);
  }

  /// The elements of the groups, of each once, in the order of the file; a set of elements for each group.
  MeshFile collect(const std::vector<std::string>& physicals) const {
    MeshFile file;
    file.path = scan_.name();
    std::vector<std::int64_t> groups;
    for (const std::string& name : physicals) {
      groups.push_back(group_of(name));
      file.element_sets.push_back({groups.back(), name, {}});
    }
    std::map<std::array<std::int32_t, 8>, std::int32_t> taken;
    std::vector<std::int32_t> used(nodes_.size(), -1);
    for (const Element& element : elements_) {
      const auto in_group = [&](std::int64_t group) { return belongs(element, group); };
      if (!groups.empty() && std::ranges::none_of(groups, in_group)) continue;
      const std::array<std::int32_t, 8> hexahedron = corners(element);
      auto place = static_cast<std::int32_t>(file.mesh.hexahedra.size());
      // Format 2.2 has an element again for each of its groups.
      if (!is_4_) place = taken.emplace(hexahedron, place).first->second;
      if (place == static_cast<std::int32_t>(file.mesh.hexahedra.size())) {
        for (const std::int32_t node : hexahedron) used[node] = 0;
        file.mesh.hexahedra.push_back(hexahedron);
        file.line.push_back(element.line);
      }
      for (std::size_t g = 0; g < groups.size(); ++g) {
        if (in_group(groups[g])) file.element_sets[g].members.push_back(place);
      }
    }
    require_elements(file, physicals);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (used[n] < 0) continue;
      used[n] = static_cast<std::int32_t>(file.mesh.nodes.size());
      file.mesh.nodes.push_back(nodes_[n]);
    }
    for (auto& hexahedron : file.mesh.hexahedra)
      for (std::int32_t& node : hexahedron) node = used[node];
    return file;
  }

  std::array<std::int32_t, 8> corners(const Element& element) const {
    const auto fail = [&](const std::string& problem) {
      throw InputError(fmt::format("{}:{}: {}", scan_.name(), element.line, problem));
    };
    if (element.type != hexahedron_type && element.type != prism_type)
      fail(fmt::format("expected 8-node hexahedra (type 5) or 6-node prisms (type 6), got {} (type {})",
                       type_name(element.type), element.type));
    static constexpr int of_hexahedron[8] = {0, 1, 2, 3, 4, 5, 6, 7}, of_prism[8] = {0, 1, 2, 2, 3, 4, 5, 5};
    std::array<std::int32_t, 8> hexahedron;
    for (int i = 0; i < 8; ++i) {
      const std::int64_t tag = element.nodes[(element.type == prism_type ? of_prism : of_hexahedron)[i]];
      const auto found = node_of_tag_.find(tag);
      if (found == node_of_tag_.end()) fail(fmt::format("expected nodes of the file, got {}, which is not there", tag));
      hexahedron[i] = static_cast<std::int32_t>(found->second);
    }
    return hexahedron;
  }

  void require_elements(const MeshFile& file, const std::vector<std::string>& physicals) const {
    const auto none = [this](const std::string& where) {
      throw InputError(fmt::format("{}: expected hexahedra or prisms{}, got none", scan_.name(), where));
    };
    if (file.mesh.hexahedra.empty() && physicals.empty()) none("");
    for (const MeshSet& set : file.element_sets) {
      if (set.members.empty()) none(fmt::format(" in the physical volume \"{}\"", set.name));
    }
    if (nodes_.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
      throw InputError(fmt::format("{}: {} nodes are more than a mesh can hold", scan_.name(), nodes_.size()));
  }

  GmshScanner scan_;
  bool is_4_ = true, has_nodes_ = false, has_elements_ = false, has_entities_ = false;
  std::map<std::string, std::int64_t> volume_groups_, other_groups_;  // tags by name
  std::map<std::int64_t, std::set<std::int64_t>> groups_of_volume_;   // 4.1
  std::unordered_map<std::int64_t, std::size_t> node_of_tag_;
  std::vector<Point> nodes_;
  std::vector<Element> elements_;
};

}  // namespace

MeshFile parse_gmsh(std::string_view text, const std::string& name, const std::vector<std::string>& physicals) {
  return Reader(text, name).read(physicals);
}

MeshFile read_gmsh(const std::string& path, const std::vector<std::string>& physicals) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || !text) throw InputError(path + ": no such file, or it cannot be read");
  return parse_gmsh(std::move(text).str(), path, physicals);
}

}  // namespace pinball
