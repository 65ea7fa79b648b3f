#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <solver/scene.hpp>

#include "verification.hpp"

/// The cases, one function per scene.
namespace pinball {

/// Place in scene.bodies; throws InputError where there is no body of that name.
std::size_t number_of_body(const Scene& scene, const std::string& name);

std::vector<VerificationRow> verify_block(const Scene& scene);
std::vector<VerificationRow> verify_cantilever(const Scene& scene);
std::vector<VerificationRow> verify_cyclic_shear(const Scene& scene);
std::vector<VerificationRow> verify_elastic_cycles(const Scene& scene);
std::vector<VerificationRow> verify_coarse_impact(const Scene& scene);
std::vector<VerificationRow> verify_crushed_block(const Scene& scene);
std::vector<VerificationRow> verify_hugoniot(const Scene& scene);
std::vector<VerificationRow> verify_material_laws(const Scene& scene);
std::vector<VerificationRow> verify_patch_test(const Scene& scene);
std::vector<VerificationRow> verify_perforated_plate(const Scene& scene);
std::vector<VerificationRow> verify_plastic_cantilever(const Scene& scene);
std::vector<VerificationRow> verify_plate_impact(const Scene& scene);
std::vector<VerificationRow> verify_refined_layer(const Scene& scene);
std::vector<VerificationRow> verify_rod_oblique(const Scene& scene);
std::vector<VerificationRow> verify_rod_plate(const Scene& scene);
std::vector<VerificationRow> verify_sphere_sphere(const Scene& scene);
std::vector<VerificationRow> verify_sphere_wall(const Scene& scene);
std::vector<VerificationRow> verify_sphere_wall_full(const Scene& scene);
std::vector<VerificationRow> verify_spinning_block(const Scene& scene);
std::vector<VerificationRow> verify_taylor_bar(const Scene& scene);
std::vector<VerificationRow> verify_taylor_johnson_cook(const Scene& scene);
std::vector<VerificationRow> verify_taylor_tetrahedra(const Scene& scene);
std::vector<VerificationRow> verify_taylor_plate(const Scene& scene);
std::vector<VerificationRow> verify_two_bars(const Scene& scene);
std::vector<VerificationRow> verify_two_blocks(const Scene& scene);
std::vector<VerificationRow> verify_uniaxial_strain(const Scene& scene);

}  // namespace pinball
