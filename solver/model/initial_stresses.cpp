#include "initial_stresses.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <kernels/material/principal_values.hpp>
#include <solver/base/error.hpp>
#include <solver/model/selection/selected_elements.hpp>

namespace pinball {

namespace {

Symmetric<double> tensor_of(const InitialStress& given) {
  const Point &s = given.stress, &t = given.shear_stress;
  return {s[0], s[1], s[2], t[0], t[1], t[2]};
}

double mean_of(const Symmetric<double>& stress) { return (stress.xx + stress.yy + stress.zz) / 3; }

/// Of Hooke's law, per volume [stress].
double energy_density(const Symmetric<double>& stress, const Material& material) {
  const double p = mean_of(stress);
  const Symmetric<double> s{stress.xx - p, stress.yy - p, stress.zz - p, stress.xy, stress.yz, stress.zx};
  const double g = material.shear_modulus, k = material.bulk_modulus;
  return (g > 0 ? contract(s, s) / (4 * g) : 0.0) + (k > 0 ? p * p / (2 * k) : 0.0);
}

const char* law_of_deformation(const Material& material) {
  if (material.plastic) return nullptr;
  if (material.mooney_rivlin) return "mooney_rivlin";
  if (material.ogden) return "ogden";
  return material.orthotropic ? "orthotropic" : nullptr;
}

/// What is wrong with a stress in elements of a material; empty: nothing.
std::string problem_of(const InitialStress& given, const Material& material) {
  const Symmetric<double> stress = tensor_of(given);
  const double size = std::sqrt(contract(stress, stress)), mean = mean_of(stress);
  const auto of_material = [&](const std::string& why) {
    return fmt::format("expected no such stress in material {}: {}", material.name, why);
  };
  if (given.plastic_strain > 0 && !material.plastic) {
    return fmt::format("expected no plastic_strain in material {}, which does not yield", material.name);
  }
  if (size == 0) return "";
  if (const char* law = law_of_deformation(material)) {
    return of_material(fmt::format("that of {} is one of the whole deformation", law));
  }
  if (material.fluid) return of_material("a fluid has its stress from its volume and its rates");
  constexpr double rounded = 1e-5;  // of components with six digits
  if ((material.equation_of_state || material.johnson_holmquist) && std::abs(mean) > rounded * size) {
    return of_material(fmt::format("its pressure is that of {}, and the mean of xx, yy and zz is {:.6g}, not 0",
                                   material.johnson_holmquist ? "johnson_holmquist" : "its equation of state", mean));
  }
  if (!material.plastic && !(principal_values(stress).smallest > -material.shear_modulus)) {
    return of_material(fmt::format("a principal stress of {:.6g} presses with more than its shear modulus",
                                   principal_values(stress).smallest));
  }
  return "";
}

/// Checks a stress once for each of the materials that it is in.
template <class S>
class StressCheck {
 public:
  StressCheck(const Model<S>& model, const std::vector<std::size_t>& material, const InitialStress& given)
      : model_(model), material_(material), given_(given), checked_(model.scene.materials.size(), false) {}

  void look_at(std::int32_t element) {
    const std::int32_t body = model_.mesh.body[element];
    if (model_.rigid_of_body[body] >= 0) {
      fail(fmt::format("expected no element of body {}, which is rigid", model_.mesh.body_names[body]));
    }
    const std::size_t material = material_[body];
    if (checked_[material]) return;
    checked_[material] = true;
    const std::string problem = problem_of(given_, model_.scene.materials[material]);
    if (!problem.empty()) fail(problem);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: {}", given_.nodes.where, problem));
  }

  const Model<S>& model_;
  const std::vector<std::size_t>& material_;
  const InitialStress& given_;
  std::vector<bool> checked_;
};

template <class S>
double initial_energy_of(const Model<S>& model, const Material& material, std::int64_t slot) {
  const std::array<double, 6> c = model.elements.stress_of(slot);
  return energy_density({c[0], c[1], c[2], c[3], c[4], c[5]}, material) *
         element_volume(model.mesh, model.element_of_slot[slot]);
}

}  // namespace

template <class S>
void set_initial_stresses(Model<S>& model) {
  if (model.scene.initial_stresses.empty()) return;
  const std::vector<std::size_t> material = material_of_bodies(model.scene);
  ElementStore& elements = model.elements;
  for (const InitialStress& given : model.scene.initial_stresses) {
    StressCheck<S> check(model, material, given);
    const Symmetric<double> s = tensor_of(given);
    const std::array<double, 6> components{s.xx, s.yy, s.zz, s.xy, s.yz, s.zx};
    for (const std::int32_t e : select_elements(model.mesh, given)) {
      check.look_at(e);
      const std::int64_t slot = model.slot_of_element[e];
      for (int c = 0; c < 6; ++c) elements.stress[elements.at(slot, c, 6)] = components[c];
      if (!elements.plastic_strain.empty()) elements.plastic_strain[slot] = given.plastic_strain;
    }
  }
  if (elements.internal_energy.empty()) return;
  for (std::int64_t slot = 0; slot < elements.slots; ++slot) {
    if (model.is_padding(slot)) continue;
    const std::size_t m = material[model.mesh.body[model.element_of_slot[slot]]];
    elements.internal_energy[slot] = initial_energy_of(model, model.scene.materials[m], slot);
  }
}

template <class S>
std::vector<double> initial_strain_energies(const Model<S>& model) {
  if (model.scene.initial_stresses.empty()) return {};
  const std::vector<std::size_t> material = material_of_bodies(model.scene);
  std::vector<double> energies(model.scene.bodies.size(), 0.0);
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    const std::int32_t body = model.mesh.body[e];
    energies[body] += initial_energy_of(model, model.scene.materials[material[body]], model.slot_of_element[e]);
  }
  return energies;
}

template void set_initial_stresses(Model<double>&);
template void set_initial_stresses(Model<float>&);
template std::vector<double> initial_strain_energies(const Model<double>&);
template std::vector<double> initial_strain_energies(const Model<float>&);

}  // namespace pinball
