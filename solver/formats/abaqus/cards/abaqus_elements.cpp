#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// How elements resist hourglassing, and factors on the bulk viscosity.
struct Controls {
  std::string hourglass = "assumed_strain";
  double coefficient = 1.0, linear = 1.0, quadratic = 1.0;
};

/// A field that cannot be below zero.
double not_negative(const AbaqusBlock& block, const DataLine& card, std::size_t field, const char* what,
                    double otherwise) {
  const double value = DataFields(card).number(field, what, otherwise);
  if (!(value >= 0))
    fail_at(card.place, fmt::format("{}: {}: expected a number >= 0, got {}", block.star_name(), what, value));
  return value;
}

/// Reports what of it this program does in another way.
Controls read_controls(AbaqusData& data, const AbaqusBlock& block) {
  Controls controls;
  if (block.option("DISTORTIONCONTROL") == "YES")
    data.report.unused(block.place, "*SECTION CONTROLS, DISTORTION CONTROL=YES",
                       "corners that are about to turn over resist in any case (element.folding_resistance)");
  DataLines lines(block);
  double factor = 1.0;
  if (const auto card = lines.next()) {
    factor = not_negative(block, *card, 0, "hourglass factor", 1.0);
    controls.linear = not_negative(block, *card, 3, "factor of the linear bulk viscosity", 1.0);
    controls.quadratic = not_negative(block, *card, 4, "factor of the quadratic bulk viscosity", 1.0);
  }
  const std::string form = block.option("HOURGLASS");
  if (form == "VISCOUS") {
    controls.hourglass = "viscous";
    controls.coefficient = 0.025 * factor;
  } else if (form == "STIFFNESS") {
    controls.hourglass = "stiffness";
    controls.coefficient = 0.05 * factor;
  }
  return controls;
}

/// Types of the elements of each part of the mesh.
std::vector<std::set<std::string>> types_of_parts(const AbaqusMesh& mesh) {
  std::vector<std::set<std::string>> types(mesh.file.parts.size());
  for (std::size_t run = 0; run < mesh.types.size(); ++run) {
    const std::size_t end = run + 1 < mesh.types.size() ? mesh.types[run + 1].first : mesh.file.part.size();
    std::int32_t last = -1;
    for (std::size_t e = mesh.types[run].first; e < end; ++e) {
      if (mesh.file.part[e] != last) types[mesh.file.part[e]].insert(mesh.types[run].type);
      last = mesh.file.part[e];
    }
  }
  return types;
}

using NamedControls = std::map<std::string, const AbaqusBlock*>;

Controls controls_of(AbaqusData& data, const NamedControls& named, const AbaqusBody& body,
                     const std::set<std::string>& types) {
  Controls controls;
  const AbaqusBlock& section = *data.mesh.sections[body.section].block;
  if (const auto name = section.value("CONTROLS")) {
    const auto found = named.find(label_key(*name));
    if (found == named.end()) fail_at(section.place, fmt::format("there is no *SECTION CONTROLS {}", *name));
    controls = read_controls(data, *found->second);
  }
  const auto is_of = [](const std::string& type, SolidShape shape) {
    const ElementType* const known = element_type(&ElementType::abaqus, type);
    return known != nullptr && known->shape == shape;
  };
  const bool full = std::ranges::any_of(types, [&](const std::string& type) {
    return is_of(type, SolidShape::hexahedron) && type.find('R') == std::string::npos;
  });
  if (full) {
    controls.hourglass = "assumed_strain";
    controls.coefficient = 1.0;
    data.report.understood(fmt::format("{}: {}, full integration: elements of assumed strain in its place", body.part,
                                       fmt::join(types, ", ")));
  }
  for (const KnownShape& shape : known_shapes()) {
    if (*shape.note == '\0') continue;
    if (std::ranges::any_of(types, [&](const std::string& type) { return is_of(type, shape.shape); }))
      data.report.understood(fmt::format("{}: {}", body.part, shape.note));
  }
  return controls;
}

/// b1 and b2, the same in all steps.
std::pair<double, double> bulk_viscosity(AbaqusData& data) {
  std::optional<std::pair<double, double>> found;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "BULKVISCOSITY") continue;
    DataLines lines(block);
    const DataLine card = lines.require("the coefficients");
    const std::pair here{not_negative(block, card, 0, "b1", 0.06), not_negative(block, card, 1, "b2", 1.2)};
    if (!found && block.step > 1) found = {0.06, 1.2};  // what holds in the steps before
    if (found && found != here) data.report.reject(block.place, "*BULK VISCOSITY that is another one than before");
    found = here;
  }
  return found.value_or(std::pair{0.06, 1.2});
}

}  // namespace

std::vector<DeckElement> abaqus_elements(AbaqusData& data) {
  const auto types = types_of_parts(data.mesh);
  const auto [linear, quadratic] = bulk_viscosity(data);
  NamedControls named;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "SECTIONCONTROLS") named.emplace(label_key(block.require("NAME")), &block);
  }
  std::vector<DeckElement> elements;
  for (const AbaqusBody& body : data.bodies) {
    const Controls controls = controls_of(data, named, body, types[body.section]);
    elements.push_back(
        {controls.hourglass, controls.coefficient, quadratic * controls.quadratic, linear * controls.linear});
  }
  if (std::ranges::any_of(elements, [](const DeckElement& e) { return e.hourglass == "assumed_strain"; }))
    data.report.understood(
        "hourglass control is that of assumed strains, as ENHANCED; Abaqus has RELAX STIFFNESS by default");
  return elements;
}

}  // namespace pinball
