#pragma once

#include <map>
#include <vector>

#include <solver/formats/lsdyna/scan/keyword_deck.hpp>
#include <solver/mesh/file/shell_layers.hpp>
#include <solver/mesh/number_index.hpp>

namespace pinball {

/// *ELEMENT_SHELL of parts of a *MAT_RIGID, with the thickness of their *SECTION_SHELL; those of other parts are passed
/// over.
class RigidShells {
 public:
  /// file: with its nodes and parts.
  RigidShells(const KeywordDeck& deck, const MeshFile& file, const NumberIndex& nodes)
      : deck_(deck), file_(file), nodes_(nodes) {}
  /// Throws InputError for a node that is not there, and for a part without a thickness.
  std::vector<RigidShell> read();

 private:
  struct Part {
    std::int32_t place = 0;
    double thickness = 0;
    std::int64_t section = 0;
  };
  void find_parts();
  void read(const KeywordBlock& block, std::vector<RigidShell>& shells) const;

  const KeywordDeck& deck_;
  const MeshFile& file_;
  const NumberIndex& nodes_;
  std::map<std::int64_t, Part> rigid_;  ///< rigid parts
};

}  // namespace pinball
