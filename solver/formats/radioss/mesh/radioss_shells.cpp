#include "radioss_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>
#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>
#include <solver/formats/radioss/layouts/radioss_mesh_cards.hpp>
#include <solver/formats/radioss/scan/radioss_fields.hpp>

namespace pinball {

RadiossShells::RadiossShells(const RadiossDeck& deck, const RadiossParts& parts, const MeshFile& file,
                             const NumberIndex& nodes)
    : deck_(deck), parts_(parts), file_(file), nodes_(nodes) {
  for (const RadiossBlock& block : deck.blocks) {
    if (is_of_shells(block)) read(block);
  }
}

/// Of a triangle the fourth node is missing, or the third once more.
void RadiossShells::read(const RadiossBlock& block) {
  const bool is_triangle = block.name == "SH3N";
  const auto part = std::ranges::find(file_.parts, block.id(), &MeshPart::id) - file_.parts.begin();
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, is_triangle ? radioss::sh3n : radioss::shell);
    RigidShell shell{f.integer(0), static_cast<std::int32_t>(part), static_cast<std::int32_t>(line->place.line),
                     *line->place.file};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int64_t id = is_triangle && i == 3 ? 0 : f.integer(1 + i);
      shell.nodes[i] = id == 0 && i == 3 ? shell.nodes[2] : nodes_.find(id);
      if (shell.nodes[i] < 0)
        fail_at(line->place, fmt::format("/{}: shell {} has node {}, which is not there", block.name, shell.id, id));
    }
    const auto& [a, b, c, d] = shell.nodes;
    if (a == b || b == c || a == c || d == a || d == b)
      fail_at(line->place,
              fmt::format("/{}: shell {} has two nodes or less: expected three or four", block.name, shell.id));
    shell.thickness = f.number("Thick");
    shells_.push_back(shell);
  }
}

/// Per part of the file.
std::vector<bool> RadiossShells::rigid_parts(const std::vector<MeshSet>& groups) const {
  std::vector<bool> rigid(file_.parts.size(), false);
  const auto take = [&](const auto& is_part_rigid) {
    for (std::size_t p = 0; p < file_.parts.size(); ++p) rigid[p] = rigid[p] || is_part_rigid(p);
  };
  const auto take_parts_in = [&](std::int64_t group) {
    const auto set = std::ranges::find(groups, group, &MeshSet::id);
    if (set == groups.end()) return;
    std::vector<bool> whole(file_.parts.size(), true);
    for (const RigidShell& shell : shells_) {
      for (const std::int32_t node : shell.nodes)
        whole[shell.part] = whole[shell.part] && std::ranges::binary_search(set->members, node);
    }
    take([&](std::size_t p) { return whole[p]; });
  };
  for (const RadiossBlock& block : deck_.blocks) {
    if (block.engine) continue;
    RadiossLines lines(block);
    if (block.name == "MAT/RIGID") {
      take([&](std::size_t p) {
        const auto part = parts_.all().find(file_.parts[p].id);
        return part != parts_.all().end() && part->second.material == block.id();
      });
    } else if (block.name == "RBODY") {
      if (const auto line = lines.next())
        take_parts_in(RadiossFields(*line, block, radioss::rigid_body).integer("grnd_ID"));
    } else if (block.name == "BCS") {
      while (const auto line = lines.next_filled()) {
        const RadiossFields f(*line, block, radioss::held);
        if (line->text.size() >= 6 && line->text.substr(3, 3) == "111") take_parts_in(f.integer("grnod_ID"));
      }
    }
  }
  return rigid;
}

double RadiossShells::thickness_of(const RigidShell& shell) const {
  if (shell.thickness > 0) return shell.thickness;
  const auto part = parts_.all().find(file_.parts[shell.part].id);
  if (part == parts_.all().end()) return 0;
  for (const RadiossBlock& block : deck_.blocks) {
    if (block.name != "PROP/SHELL" || block.id() != part->second.property) continue;
    RadiossLines lines(block);
    const DataLine form = lines.next_or_blank(), damping = lines.next_or_blank(), line = lines.next_or_blank();
    const RadiossFields of_form(form, block, radioss::shell_form), of_damping(damping, block, radioss::shell_damping);
    return RadiossFields(line, block, radioss::shell_thickness).number("Thick");
  }
  return 0;
}

std::vector<RigidShell> RadiossShells::that_stay_as_they_are(const std::vector<MeshSet>& groups) const {
  std::vector<RigidShell> found;
  if (shells_.empty()) return found;
  const std::vector<bool> rigid = rigid_parts(groups);
  for (RigidShell shell : shells_) {
    if (!rigid[shell.part]) continue;
    shell.thickness = thickness_of(shell);
    if (!(shell.thickness > 0))
      throw InputError(
          fmt::format("{}:{}: shell {} has no thickness: expected Thick > 0 of the /PROP/SHELL of /PART/{}", shell.file,
                      shell.line, shell.id, file_.parts[shell.part].id));
    found.push_back(shell);
  }
  return found;
}

}  // namespace pinball
