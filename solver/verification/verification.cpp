#include "verification.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include <solver/base/error.hpp>

#include "cases.hpp"

namespace pinball {

namespace {

/// Brings those that have the names to the front, in their order; the others keep theirs. what: they are, for people.
template <class Named>
void put_in_order(const Scene& scene, const char* what, const std::vector<std::string>& names,
                  std::vector<Named>& all) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = std::find_if(all.begin() + static_cast<std::ptrdiff_t>(std::min(i, all.size())), all.end(),
                                    [&](const Named& one) { return one.name == names[i]; });
    if (found == all.end()) {
      throw InputError(
          fmt::format("{}: expected a {} named {}, which `pinball verify` compares", scene.path, what, names[i]));
    }
    std::rotate(all.begin() + static_cast<std::ptrdiff_t>(i), found, found + 1);
  }
}

}  // namespace

std::size_t number_of_body(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) { return body.name == name; });
  if (found == scene.bodies.end()) {
    throw InputError(fmt::format("{}: expected a body named {}, which `pinball verify` compares", scene.path, name));
  }
  return static_cast<std::size_t>(found - scene.bodies.begin());
}

VerificationRow compare(const std::string& quantity, double value, double reference, double tolerance,
                        const std::string& source) {
  const double error = std::abs(value - reference) / (reference != 0 ? std::abs(reference) : 1.0);
  return {"", quantity, value, reference, source, error, tolerance, error <= tolerance};
}

VerificationRow compare_with_zero(const std::string& quantity, double value, double tolerance,
                                  const std::string& source) {
  return compare(quantity, value, 0.0, tolerance, source);
}

const std::vector<VerificationCase>& verification_cases() {
  static const std::vector<VerificationCase> cases{
      {"patch_test", verify_patch_test, {"cube"}, {"patch"}},
      {"uniaxial_strain", verify_uniaxial_strain, {"block"}, {"copper"}},
      {"cyclic_shear",
       verify_cyclic_shear,
       {"isotropic", "mixed", "kinematic", "curve", "total_rate", "plastic_rate"},
       {"isotropic", "mixed", "kinematic", "curve", "total_rate", "plastic_rate"}},
      {"elastic_cycles", verify_elastic_cycles, {"cube", "bar"}, {"rubber"}},
      {"material_laws", verify_material_laws},
      {"spinning_block", verify_spinning_block, {"bar"}, {"steel"}},
      {"block", verify_block, {"block"}, {"steel"}},
      {"plate_impact", verify_plate_impact, {"plate"}, {"copper"}},
      {"hugoniot", verify_hugoniot, {"plate"}, {"copper"}},
      {"coarse_impact", verify_coarse_impact, {"cube", "plate"}, {"elastic", "plastic"}},
      {"crushed_block", verify_crushed_block, {"block"}, {"steel"}},
      {"cantilever", verify_cantilever, {"beam"}, {"elastic"}},
      {"plastic_cantilever", verify_plastic_cantilever, {"beam"}, {"plastic"}},
      {"two_blocks", verify_two_blocks, {"lower", "upper"}, {"steel"}},
      {"taylor_bar", verify_taylor_bar, {"bar"}, {"copper"}},
      {"taylor_johnson_cook", verify_taylor_johnson_cook, {"bar"}, {"steel"}},
      {"taylor_tetrahedra", verify_taylor_tetrahedra, {"bar"}, {"copper"}},
      {"taylor_plate", verify_taylor_plate, {"bar", "plate"}, {"copper", "held"}},
      {"two_bars", verify_two_bars, {"bar1", "bar2"}, {"bar"}},
      {"sphere_wall", verify_sphere_wall, {"sphere"}, {"soft"}},
      {"sphere_wall_full", verify_sphere_wall_full, {"sphere"}, {"soft"}},
      {"sphere_sphere", verify_sphere_sphere, {"upper", "lower"}, {"soft"}},
      {"rod_plate", verify_rod_plate, {"rod", "plate"}, {"copper", "steel"}},
      {"rod_oblique", verify_rod_oblique, {"rod", "plate"}, {"rod_steel", "plate_steel"}},
      {"perforated_plate", verify_perforated_plate, {"projectile", "plate"}, {"plate", "tool_steel"}},
      {"refined_layer", verify_refined_layer, {"block"}, {"steel"}},
  };
  return cases;
}

std::vector<VerificationRow> compare_scene(const VerificationCase& verification, Scene scene) {
  put_in_order(scene, "body", verification.bodies, scene.bodies);
  put_in_order(scene, "material", verification.materials, scene.materials);
  const auto differs = [&scene](const char* what) {
    return InputError(
        fmt::format("{}: expected what `pinball verify` compares, {} is not there: run the scene as it "
                    "comes along, or give this one another name",
                    scene.path, what));
  };
  try {
    return verification.run(scene);
  } catch (const std::bad_variant_access&) {
    throw differs("a body's mesh of the given kind");
  } catch (const std::bad_optional_access&) {
    throw differs("a law of a material");
  } catch (const std::out_of_range&) {
    throw differs("a load, motion, wall or number of a law");
  }
}

std::vector<VerificationRow> verify_scene(const VerificationCase& verification, Device device) {
  std::vector<VerificationRow> rows;
  try {
    Scene scene = read_scene(find_scene(verification.scene));
    scene.device = device;
    rows = compare_scene(verification, std::move(scene));
  } catch (const RunError& error) {
    rows = {{"", "run to the end", std::nan(""), 0.0, error.what(), std::nan(""), 0.0, false}};
  }
  for (VerificationRow& row : rows) row.scene = verification.scene;
  return rows;
}

}  // namespace pinball
