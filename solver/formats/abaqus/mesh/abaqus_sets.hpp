#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <solver/formats/abaqus/scan/abaqus_assembly.hpp>
#include <solver/mesh/number_index.hpp>

#include "abaqus_mesh.hpp"

namespace pinball {

/// Sets of nodes and elements, and surfaces, of Abaqus input: each component has its own names, and a set may be put
/// together from many keywords in any order. Members are places in the mesh, ascending.
class AbaqusSets {
 public:
  /// nodes, elements: per component, places counted from its first. mesh, of which components, ranges and types are
  /// known, and file have to stay.
  AbaqusSets(const AbaqusMesh& mesh, MeshFile& file, std::vector<NumberIndex> nodes, std::vector<NumberIndex> elements);

  /// Nodes or elements that *NODE, NSET= or *ELEMENT, ELSET= gives a name: places from first to before last.
  void add_range(std::size_t component, bool of_nodes, const std::string& name, std::size_t first, std::size_t last);
  /// An element that the mesh does not have, and sets may name: one of one node.
  void pass_over(std::size_t component, std::int64_t number) { passed_over_.insert({component, number}); }
  /// Takes the keywords NSET, ELSET and SURFACE of all components.
  void read();
  /// Members of a set, or of "INSTANCE.SET", as a component calls it; or the one with a number. Throws InputError with
  /// the place where it is not there.
  const std::vector<std::int32_t>& members(std::size_t component, bool of_nodes, const std::string& label,
                                           const DeckPlace& place);
  /// Adds all sets and surfaces to the file, under their names in it; returns their keys.
  AbaqusKeys name_all();

 private:
  /// Of a component, of nodes or of elements, by its label.
  struct SetKey {
    std::size_t component = 0;
    bool of_nodes = false;
    std::string key;
  };
  struct Set {
    std::string name;
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    std::vector<const AbaqusBlock*> blocks;
    std::vector<std::int32_t> members;
    std::string problem;
    enum class State { open, at_work, done } state = State::open;
    std::vector<SetKey> needs{};  ///< sets that it is made of, while it is at work
  };
  struct Surface {
    std::string name, key;
    const AbaqusBlock* block;
  };
  struct NameInFile {
    std::string name, key;
  };
  using Sets = std::map<std::string, Set>;

  Sets& sets(std::size_t component, bool of_nodes) { return (of_nodes ? node_sets_ : element_sets_)[component]; }
  /// Finds the members of a set, and before them those of all sets that it is made of, however deep: no call for each.
  void resolve(const SetKey& first);
  void fill(const SetKey& key, Set& set);
  /// Which sets a label may mean, as a component calls it.
  std::vector<SetKey> sets_of_label(std::size_t component, bool of_nodes, std::string_view label) const;
  std::vector<SetKey> sets_in(const SetKey& key, const Set& set) const;
  Set* find(const SetKey& key);
  void add_block(std::size_t component, bool of_nodes, const AbaqusBlock& block, std::vector<std::int32_t>& members);
  void generate(std::size_t component, bool of_nodes, const AbaqusBlock& block, const DataLine& card,
                std::vector<std::int32_t>& members);
  std::optional<std::int32_t> numbered(std::size_t component, bool of_nodes, std::int64_t number) const;
  std::optional<std::size_t> component_of(const std::string& instance) const;
  void add_entry(std::size_t component, bool of_nodes, const std::string& label, const DeckPlace& place,
                 std::vector<std::int32_t>& members);
  void add_nodes_of_elements(const std::vector<std::int32_t>& elements, std::vector<std::int32_t>& nodes) const;

  void name_surface(std::size_t component, const Surface& surface);
  void add_faces(std::size_t component, const DataLine& card, std::vector<std::array<std::int32_t, 4>>& faces);
  /// Of rigid elements none.
  const std::vector<std::array<std::int32_t, 6>>& neighbours();
  /// Names of something of a component in the file: qualified and, where nothing else has it, the name alone.
  std::vector<NameInFile> names_in_file(std::size_t component, const std::string& name, const std::string& key,
                                        const std::map<std::string, int>& uses) const;

  const std::vector<AbaqusComponent>& components_;
  const std::vector<AbaqusRange>& ranges_;
  const std::vector<AbaqusElements>& types_;
  MeshFile& file_;
  std::map<std::string, std::size_t> component_of_key_;
  std::vector<NumberIndex> nodes_, elements_;
  std::set<std::pair<std::size_t, std::int64_t>> passed_over_;
  std::vector<Sets> node_sets_, element_sets_;
  std::vector<std::vector<Surface>> surfaces_;
  std::map<std::string, int> surface_uses_, node_set_uses_;
  AbaqusKeys keys_;
  std::vector<std::array<std::int32_t, 6>> neighbours_;
};

}  // namespace pinball
