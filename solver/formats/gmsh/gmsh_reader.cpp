#include "gmsh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>

#include <solver/base/error.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/mesh/file/mesh_scanner.hpp>

#include "gmsh_collector.hpp"
#include "gmsh_groups.hpp"
#include "gmsh_types.hpp"

/// Format: "MSH file format" in the reference manual of Gmsh, versions 2.2 and 4.1.
namespace pinball {
namespace {

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& name, const std::vector<std::string>& physicals)
      : scan_(text, name), groups_(name), physicals_(physicals) {}

  MeshFile read() {
    read_format();
    while (!scan_.at_end()) read_section(std::string(scan_.word("a section such as $Nodes")));
    if (!collector_) scan_.fail("a section $Nodes", "");
    if (!has_elements_) scan_.fail("a section $Elements", "");
    return collector_->finish(groups_, physicals_);
  }

 private:
  void read_format() {
    scan_.keyword("$MeshFormat");
    const std::string version(scan_.word("the format's version"));
    if (version != "2.2" && version != "4.1")
      scan_.fail("format 2.2 or 4.1 (gmsh -format msh41 or msh22 writes them)", version);
    is_4_ = version == "4.1";
    const std::int64_t binary = scan_.integer("0 for a text file, 1 for a binary one");
    if (binary != 0 && binary != 1) scan_.fail("0 for a text file, 1 for a binary one", std::to_string(binary));
    const std::int64_t size = scan_.count("the size of a number");
    if (binary == 1) {
      if (size != 8) scan_.fail("numbers of 8 bytes in a binary file", std::to_string(size));
      scan_.set_binary();
      read_byte_order();
    }
    scan_.keyword("$EndMeshFormat");
  }

  void read_byte_order() {
    scan_.begin_data();
    const std::int64_t one = scan_.data_integer("the number 1 in four bytes");
    if (one == 0x01000000)
      scan_.fail("numbers in the byte order of this machine (gmsh writes them anew)", "those of the other byte order");
    if (one != 1) scan_.fail("the number 1 in four bytes", std::to_string(one));
    scan_.end_data();
  }

  void read_section(const std::string& section) {
    if (section.size() < 2 || section[0] != '$') scan_.fail("a section such as $Nodes", section);
    const std::string end = "$End" + section.substr(1);
    if (section == "$PhysicalNames") {
      read_physical_names();
    } else if (section == "$Entities" && is_4_) {
      scan_.begin_data();
      read_entities();
    } else if (section == "$Nodes" || (section == "$ParametricNodes" && !is_4_)) {
      if (collector_) scan_.fail("one section $Nodes", "another one");
      is_4_ ? read_node_blocks() : read_nodes(section == "$ParametricNodes");
      index_nodes();
    } else if (section == "$Elements") {
      if (!collector_) scan_.fail("a section $Nodes before $Elements", section);
      if (has_elements_) scan_.fail("one section $Elements", "another one");
      has_elements_ = true;
      is_4_ ? read_element_blocks() : read_elements();
    } else {
      return scan_.skip_to(end);
    }
    scan_.end_data();
    scan_.keyword(end);
  }

  void read_physical_names() {
    const std::int64_t count = scan_.count("the number of physical names");
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t dimension = scan_.count("the dimension of a physical group");
      if (dimension > 3) scan_.fail("a dimension from 0 to 3", std::to_string(dimension));
      const std::int64_t tag = scan_.integer("the tag of a physical group");
      groups_.add_name(dimension, tag, scan_.quoted("a physical name in quotes"));
    }
  }

  void read_entities() {
    std::int64_t counts[4];
    for (auto& count : counts) count = scan_.data_count("a number of points, curves, surfaces or volumes");
    groups_.found_entities();
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::int64_t i = 0; i < counts[dimension]; ++i) read_entity(dimension);
    }
  }

  void read_entity(int dimension) {
    const std::int64_t tag = scan_.data_integer("the tag of an entity");
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) scan_.data_number("a bound of an entity");
    const std::int64_t groups = scan_.data_count("a number of physical groups");
    for (std::int64_t k = 0; k < groups; ++k) {
      // Its sign is an orientation.
      groups_.add_entity(dimension, tag, std::abs(scan_.data_integer("the tag of a physical group")));
    }
    if (dimension == 0) return;
    const std::int64_t boundaries = scan_.data_count("a number of bounding entities");
    for (std::int64_t k = 0; k < boundaries; ++k) scan_.data_integer("the tag of a bounding entity");
  }

  void reserve_nodes(std::int64_t count, std::int64_t bytes) {
    scan_.require_room(count, bytes, 4, "as many nodes");
    nodes_.reserve(nodes_.size() + count);
    node_ids_.reserve(nodes_.size() + count);
  }

  void add_coordinates() {
    Point x;
    for (double& coordinate : x) coordinate = scan_.data_number("a coordinate of a node");
    nodes_.push_back(x);
  }

  void read_nodes(bool parametric) {
    const std::int64_t count = scan_.count("the number of nodes");
    if (parametric && scan_.binary()) scan_.fail("a section $Nodes in a binary file", "$ParametricNodes");
    scan_.begin_data();
    reserve_nodes(count, 28);
    for (std::int64_t i = 0; i < count; ++i) {
      node_ids_.push_back(scan_.data_integer("the tag of a node"));
      note_node_line();
      add_coordinates();
      if (parametric) scan_.skip_line("the entity of a node");
    }
  }

  void read_node_blocks() {
    scan_.begin_data();
    const std::int64_t blocks = scan_.data_count("the number of blocks of nodes"),
                       total = scan_.data_count("the number of nodes");
    reserve_nodes(total, 32);
    for (const char* bound : {"the smallest tag of the nodes", "the largest tag of the nodes"}) scan_.data_long(bound);
    for (std::int64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = scan_.data_integer("the dimension of an entity");
      if (dimension < 0 || dimension > 3) scan_.fail("a dimension from 0 to 3", std::to_string(dimension));
      scan_.data_integer("the tag of an entity");
      const bool parametric = scan_.data_integer("1 if nodes have parametric coordinates, else 0") != 0;
      const std::int64_t count = scan_.data_count("the number of nodes in the block");
      scan_.require_room(count, 32, 4, "as many nodes");
      for (std::int64_t i = 0; i < count; ++i) {
        node_ids_.push_back(scan_.data_long("the tag of a node"));
        note_node_line();
      }
      for (std::int64_t i = 0; i < count; ++i) {
        add_coordinates();
        for (std::int64_t k = 0; parametric && k < dimension; ++k) scan_.data_number("a parametric coordinate");
      }
    }
    if (std::ssize(nodes_) != total)
      scan_.fail(fmt::format("{} nodes in the blocks", total), std::to_string(nodes_.size()));
  }

  void note_node_line() {
    if (scan_.binary()) return;
    const std::size_t node = node_ids_.size() - 1;
    const auto expected = lines_.empty() ? 0 : lines_.back().line + static_cast<int>(node - lines_.back().node);
    if (scan_.line() != expected) lines_.push_back({node, scan_.line()});
  }

  /// "NAME:LINE" of a node, as far as there are lines.
  std::string place_of_node(std::size_t node) const {
    const auto after = [](std::size_t n, const NodeLine& line) { return n < line.node; };
    const auto found = std::upper_bound(lines_.begin(), lines_.end(), node, after);
    if (found == lines_.begin()) return scan_.name();
    return fmt::format("{}:{}", scan_.name(), (found - 1)->line + static_cast<int>(node - (found - 1)->node));
  }

  void index_nodes() {
    if (nodes_.size() > std::numeric_limits<std::int32_t>::max())
      throw InputError(fmt::format("{}: {} nodes are more than a mesh can hold", scan_.name(), nodes_.size()));
    NumberIndex index(node_ids_);
    if (const std::int32_t again = index.repeated(); again >= 0) {
      throw InputError(
          fmt::format("{}: expected a node of its own, got \"{} again\"", place_of_node(again), node_ids_[again]));
    }
    collector_.emplace(scan_.name(), std::move(nodes_), std::move(node_ids_), std::move(index));
  }

  void read_elements() {
    const std::int64_t count = scan_.count("the number of elements");
    scan_.begin_data();
    scan_.require_room(count, 8, 4, "as many elements");
    collector_->begin_elements(groups_.volumes(physicals_, is_4_), count, true);
    if (!scan_.binary()) {
      for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t id = scan_.integer("the number of an element"), type = scan_.count("the type of an element"),
                           tags = scan_.count("the number of tags of an element");
        read_tagged_element(id, type, tags);
      }
      return;
    }
    for (std::int64_t left = count; left > 0;) {
      const std::int64_t type = scan_.data_integer("the type of elements"),
                         follow = scan_.data_integer("a number of elements that follow"),
                         tags = scan_.data_integer("the number of tags of an element");
      if (follow < 1 || follow > left) scan_.fail(fmt::format("1 to {} elements", left), std::to_string(follow));
      for (std::int64_t i = 0; i < follow; ++i) {
        read_tagged_element(scan_.data_integer("the number of an element"), type, tags);
      }
      left -= follow;
    }
  }

  /// Of format 2.2: the first tag is the physical group.
  void read_tagged_element(std::int64_t id, std::int64_t type, std::int64_t tags) {
    std::int64_t group = 0;
    for (std::int64_t k = 0; k < tags; ++k) {
      const std::int64_t tag = scan_.data_integer("a tag of an element");
      if (k == 0) group = std::abs(tag);
    }
    const std::span<const std::int64_t> groups(&group, group == 0 ? 0 : 1);
    read_nodes_of_element(gmsh::dimension_of(type), type, groups, id);
  }

  void read_element_blocks() {
    scan_.begin_data();
    const std::int64_t blocks = scan_.data_count("the number of blocks of elements");
    const std::int64_t total = scan_.data_count("the number of elements");
    scan_.require_room(total, 16, 2, "as many elements");
    for (const char* bound : {"the smallest tag of the elements", "the largest tag of the elements"})
      scan_.data_long(bound);
    collector_->begin_elements(groups_.volumes(physicals_, is_4_), total, false);
    for (std::int64_t block = 0; block < blocks; ++block) {
      const std::int64_t dimension = scan_.data_integer("the dimension of an entity");
      if (dimension < 0 || dimension > 3) scan_.fail("a dimension from 0 to 3", std::to_string(dimension));
      const std::int64_t entity = scan_.data_integer("the tag of an entity"),
                         type = scan_.data_integer("the type of the elements"),
                         count = scan_.data_count("the number of elements in the block");
      if (gmsh::nodes_of(type) > 0 && gmsh::dimension_of(type) != dimension)
        scan_.fail(fmt::format("a type of elements of dimension {}", dimension), std::to_string(type));
      const auto groups = groups_.of_entity(dimension, entity);
      for (std::int64_t i = 0; i < count; ++i) {
        read_nodes_of_element(dimension, type, groups, scan_.data_long("the tag of an element"));
      }
    }
  }

  void read_nodes_of_element(int dimension, std::int64_t type, std::span<const std::int64_t> groups, std::int64_t id) {
    const int line = scan_.binary() ? 0 : scan_.line();
    if (dimension == 3 && collector_->wants(groups) && !is_read(type))
      fail_element(id, line,
                   fmt::format("expected types of {}, got {} (type {})", names_of_types(&ElementType::gmsh),
                               gmsh::name_of(type), type));
    const bool wanted = dimension == 3 ? collector_->wants(groups) : !groups.empty();
    if (wanted && is_read(type)) {
      add_element(dimension, type, groups, id, line);
    } else {
      skip_nodes(type);
      if (dimension == 3 && !wanted) collector_->leave_out(groups);
      if (wanted) collector_->add_boundary(dimension, {}, groups, not_read(type, id, line));
    }
  }

  static bool is_read(std::int64_t type) {
    return type == gmsh::line || type == gmsh::triangle || type == gmsh::quadrangle || type == gmsh::point ||
           type == gmsh::line_3 || type == gmsh::triangle_6 || element_type(&ElementType::gmsh, type) != nullptr;
  }

  std::string place_of_element(std::int64_t id, int line) const {
    return line > 0 ? fmt::format("{}:{}", scan_.name(), line) : fmt::format("{}: element {}", scan_.name(), id);
  }
  std::string not_read(std::int64_t type, std::int64_t id, int line) const {
    return fmt::format(
        "{}: expected points, 2-node lines, 3-node triangles or 4-node quadrangles, or "
        "those of tetrahedra of 10 nodes, got {} (type {})",
        place_of_element(id, line), gmsh::name_of(type), type);
  }
  [[noreturn]] void fail_element(std::int64_t id, int line, const std::string& problem) const {
    throw InputError(fmt::format("{}: {}", place_of_element(id, line), problem));
  }

  void skip_nodes(std::int64_t type) {
    if (!scan_.binary()) return scan_.skip_line("the nodes of an element");
    const int count = gmsh::nodes_of(type);
    if (count == 0) scan_.fail("a type of elements whose number of nodes is known", std::to_string(type));
    for (int i = 0; i < count; ++i) read_node_of_element();
  }

  /// Numbers of nodes have four bytes in format 2.2.
  std::int64_t read_node_of_element() {
    return is_4_ ? scan_.data_long("a node of an element") : scan_.data_integer("a node of an element");
  }

  void add_element(int dimension, std::int64_t type, std::span<const std::int64_t> groups, std::int64_t id, int line) {
    std::array<std::int32_t, most_nodes_of_element> nodes;
    const int count = gmsh::nodes_of(type);
    for (int i = 0; i < count; ++i) {
      const std::int64_t node = read_node_of_element();
      nodes[i] = collector_->node(node);
      if (nodes[i] < 0)
        fail_element(id, line, fmt::format("expected nodes of the file, got {}, which is not there", node));
    }
    if (dimension < 3) {
      return collector_->add_boundary(dimension, {nodes.data(), static_cast<std::size_t>(count)}, groups, "");
    }
    const ElementType& volume = *element_type(&ElementType::gmsh, type);
    if (volume.has_edge_nodes) std::swap(nodes[8], nodes[9]);  // Gmsh has the edge CD before BD
    collector_->add_volume(volume, nodes, groups, id, line);
  }

  /// Where a run of nodes begins that stand in lines of their own.
  struct NodeLine {
    std::size_t node;
    int line;
  };

  MeshScanner scan_;
  GmshGroups groups_;
  const std::vector<std::string>& physicals_;
  bool is_4_ = true, has_elements_ = false;
  std::vector<Point> nodes_;
  std::vector<std::int64_t> node_ids_;
  std::vector<NodeLine> lines_;
  std::optional<GmshCollector> collector_;
};

}  // namespace

MeshFile parse_gmsh(std::string_view text, const std::string& name, const std::vector<std::string>& physicals) {
  return GmshReader(text, name, physicals).read();
}

MeshFile read_gmsh(const std::string& path, const std::vector<std::string>& physicals) {
  const std::string bytes = bytes_of_file(path);
  MeshFile file = parse_gmsh(bytes, path, physicals);
  file.sources = {{path, hash_of_bytes(bytes)}};
  return file;
}

}  // namespace pinball
