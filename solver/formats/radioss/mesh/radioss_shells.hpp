#pragma once

#include <cstdint>
#include <vector>

#include <solver/formats/radioss/scan/radioss_deck.hpp>
#include <solver/mesh/file/shell_layers.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh/number_index.hpp>

#include "radioss_parts.hpp"

namespace pinball {

/// Whether a keyword has shells.
inline bool is_of_shells(const RadiossBlock& block) { return block.name == "SHELL" || block.name == "SH3N"; }

/// Shells of Radioss input: /SHELL and /SH3N.
class RadiossShells {
 public:
  /// All have to stay; file has its nodes and parts. Throws InputError for a node that is not there.
  RadiossShells(const RadiossDeck& deck, const RadiossParts& parts, const MeshFile& file, const NumberIndex& nodes);

  const std::vector<RigidShell>& all() const { return shells_; }
  /// Those of parts that do not deform: of a /MAT/RIGID, or all of whose nodes are of one /RBODY, or held by one /BCS
  /// along all axes, with the thickness of the shell, or of its /PROP/SHELL. groups: of nodes, those of shells among
  /// them. Throws InputError for shells without a thickness.
  std::vector<RigidShell> that_stay_as_they_are(const std::vector<MeshSet>& groups) const;

 private:
  void read(const RadiossBlock& block);
  std::vector<bool> rigid_parts(const std::vector<MeshSet>& groups) const;
  double thickness_of(const RigidShell& shell) const;

  const RadiossDeck& deck_;
  const RadiossParts& parts_;
  const MeshFile& file_;
  const NumberIndex& nodes_;
  std::vector<RigidShell> shells_;  ///< without what their property says
};

}  // namespace pinball
