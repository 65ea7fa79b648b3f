#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>

#include <solver/base/point.hpp>

#include "abaqus_material.hpp"
#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// Nine constants: eight of the first line and one of the second.
std::array<double, 9> nine_constants(AbaqusData& data, const AbaqusBlock& block) {
  DataLines lines(block);
  const DataLine first = lines.require("eight constants, and a ninth in the next line");
  const DataFields f(first);
  std::array<double, 9> constants{};
  for (std::size_t i = 0; i < 8; ++i) constants[i] = f.number(i, fmt::format("constant {}", i + 1));
  const DataLine second = lines.require("the ninth constant");
  const DataFields g(second);
  constants[8] = g.number(0, "constant 9");
  if (lines.next()) data.report.reject(block.place, "*ELASTIC that depends on temperature or fields");
  return constants;
}

/// E_1, E_2, E_3, nu_12, nu_13, nu_23, G_12, G_13, G_23.
struct EngineeringConstants {
  Point young, poisson, shear;
};

/// Of D1111, D1122, D2222, D1133, D2233, D3333, D1212, D1313, D2323: what strain a stress along one axis makes.
EngineeringConstants of_moduli(const std::array<double, 9>& d, const DeckPlace& place) {
  const auto [d11, d12, d22, d13, d23, d33, g12, g13, g23] = d;
  const double a11 = d22 * d33 - d23 * d23, a22 = d11 * d33 - d13 * d13, a33 = d11 * d22 - d12 * d12,
               a12 = d13 * d23 - d12 * d33, a13 = d12 * d23 - d13 * d22, a23 = d12 * d13 - d11 * d23;
  const double determinant = d11 * a11 + d12 * a12 + d13 * a13;
  if (!(d11 > 0 && a33 > 0 && determinant > 0))
    fail_at(place,
            "*ELASTIC: expected moduli with which every strain has an energy: D1111 > 0, D1111 D2222 > D1122^2 "
            "and a determinant of the first six > 0");
  return {
      {determinant / a11, determinant / a22, determinant / a33}, {-a12 / a11, -a13 / a11, -a23 / a22}, {g12, g13, g23}};
}

/// First and second axis.
using TwoAxes = std::array<Point, 2>;

/// Of *ORIENTATION as it lies in a component.
TwoAxes read_axes(AbaqusData& data, const AbaqusBlock& block, const InstancePlacement& placement) {
  const std::string system = block.option("SYSTEM"), definition = block.option("DEFINITION");
  if (!system.empty() && system != "RECTANGULAR")
    data.report.reject(block.place, "*ORIENTATION, SYSTEM=" + system, "axes are the same everywhere: RECTANGULAR");
  if (!definition.empty() && definition != "COORDINATES")
    data.report.reject(block.place, "*ORIENTATION, DEFINITION=" + definition, "give COORDINATES");
  DataLines lines(block);
  const DataLine card = lines.require("points on the first axis and in the plane of the first two");
  const DataFields f(card);
  TwoAxes axes{};
  const Point origin{f.number(6, "x of the origin", 0.0), f.number(7, "y of the origin", 0.0),
                     f.number(8, "z of the origin", 0.0)};
  for (std::size_t i = 0; i < 6; ++i) axes[i / 3][i % 3] = f.number(i, fmt::format("field {}", i + 1)) - origin[i % 3];
  if (const auto more = lines.next()) {
    const DataFields turn(*more);
    if (turn.number(1, "angle", 0.0) != 0)
      data.report.reject(block.place, "*ORIENTATION with a further rotation", "give the axes as they are");
  }
  if (block.part.empty()) return axes;
  const Point zero = placement.apply({});
  for (Point& axis : axes) {
    axis = placement.apply(axis);
    for (std::size_t k = 0; k < 3; ++k) axis[k] -= zero[k];
  }
  return axes;
}

/// The orientation that a section names; null: none. Of several of one name the one of its part.
const AbaqusBlock* orientation_of(const AbaqusData& data, const AbaqusBlock& section) {
  const auto name = section.value("ORIENTATION");
  if (!name) return nullptr;
  const AbaqusBlock* found = nullptr;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "ORIENTATION" || label_key(block.require("NAME")) != label_key(*name)) continue;
    if (found == nullptr || block.part == section.part) found = &block;
  }
  if (found == nullptr) fail_at(section.place, fmt::format("there is no *ORIENTATION {}", *name));
  return found;
}

/// The axes of all sections of a material, which have to be the same; none: those of the scene.
std::optional<TwoAxes> axes_of(AbaqusData& data, const std::string& material) {
  std::optional<TwoAxes> axes;
  bool first = true;
  for (const AbaqusBody& body : data.bodies) {
    if (body.material != material) continue;
    const AbaqusSection& section = data.mesh.sections[body.section];
    const AbaqusBlock* block = orientation_of(data, *section.block);
    std::optional<TwoAxes> own;
    if (block != nullptr) own = read_axes(data, *block, data.mesh.components[section.component].placement);
    if (!first && own != axes) {
      data.report.reject(section.block->place,
                         "*SOLID SECTION: an ORIENTATION other than another section's of its material",
                         "give it a material of its own");
      return axes;
    }
    axes = own;
    first = false;
  }
  return axes;
}

}  // namespace

bool is_orthotropic(const AbaqusBlock& elastic) {
  const std::string type = elastic.option("TYPE");
  return type.starts_with("ORTHO") || type == "ENGINEERINGCONSTANTS";
}

void set_orthotropic_elasticity(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                                MaterialKeys keys) {
  if (const AbaqusBlock* plastic = material.deck.option("PLASTIC"))
    data.report.reject(plastic->place, "*PLASTIC beside *ELASTIC of another type than ISOTROPIC",
                       "what yields is isotropic");
  const std::array<double, 9> given = nine_constants(data, block);
  EngineeringConstants constants{
      {given[0], given[1], given[2]}, {given[3], given[4], given[5]}, {given[6], given[7], given[8]}};
  if (block.option("TYPE").starts_with("ORTHO")) constants = of_moduli(given, block.place);
  InnerKeys<OrthotropicSettings> law;
  law.set("young_moduli", constants.young);
  law.set("poisson_ratios", constants.poisson);
  law.set("shear_moduli", constants.shear);
  if (const auto axes = axes_of(data, material.key)) {
    law.set("first_axis", (*axes)[0]);
    law.set("second_axis", (*axes)[1]);
  }
  keys.from({"*ELASTIC", block.place});
  keys.set("orthotropic", law.value());
}

void tell_unused_orientations(AbaqusData& data, const std::set<std::string>& orthotropic) {
  std::set<const AbaqusBlock*> used;
  for (const AbaqusBody& body : data.bodies) {
    const AbaqusBlock& section = *data.mesh.sections[body.section].block;
    if (orthotropic.contains(body.material)) used.insert(orientation_of(data, section));
  }
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "ORIENTATION" || used.contains(&block)) continue;
    data.report.unused(block.place, "*ORIENTATION", "it is of no orthotropic material");
    if (block.log != nullptr) block.log->done(&block);
  }
}

}  // namespace pinball
