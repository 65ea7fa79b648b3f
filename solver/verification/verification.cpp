#include "verification.hpp"

#include <cmath>

#include <solver/base/error.hpp>

#include "cases.hpp"

namespace pinball {

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
      {"patch_test", verify_patch_test},
      {"uniaxial_strain", verify_uniaxial_strain},
      {"cyclic_shear", verify_cyclic_shear},
      {"elastic_cycles", verify_elastic_cycles},
      {"material_laws", verify_material_laws},
      {"spinning_block", verify_spinning_block},
      {"block", verify_block},
      {"plate_impact", verify_plate_impact},
      {"hugoniot", verify_hugoniot},
      {"coarse_impact", verify_coarse_impact},
      {"crushed_block", verify_crushed_block},
      {"cantilever", verify_cantilever},
      {"plastic_cantilever", verify_plastic_cantilever},
      {"two_blocks", verify_two_blocks},
      {"taylor_bar", verify_taylor_bar},
      {"taylor_johnson_cook", verify_taylor_johnson_cook},
      {"taylor_tetrahedra", verify_taylor_tetrahedra},
      {"taylor_plate", verify_taylor_plate},
      {"two_bars", verify_two_bars},
      {"sphere_wall", verify_sphere_wall},
      {"sphere_wall_full", verify_sphere_wall_full},
      {"sphere_sphere", verify_sphere_sphere},
      {"rod_plate", verify_rod_plate},
      {"rod_oblique", verify_rod_oblique},
      {"perforated_plate", verify_perforated_plate},
      {"refined_layer", verify_refined_layer},
  };
  return cases;
}

std::vector<VerificationRow> verify_scene(const VerificationCase& verification, Device device) {
  std::vector<VerificationRow> rows;
  try {
    Scene scene = read_scene(find_scene(verification.scene));
    scene.device = device;
    rows = verification.run(scene);
  } catch (const RunError& error) {
    rows = {{"", "run to the end", std::nan(""), 0.0, error.what(), std::nan(""), 0.0, false}};
  }
  for (VerificationRow& row : rows) row.scene = verification.scene;
  return rows;
}

}  // namespace pinball
