#pragma once

#include <cstdint>

#include "assumed_strain.hpp"
#include "hourglass.hpp"
#include "material/bulk_viscosity.hpp"
#include "material/crushable_foam.hpp"
#include "material/drucker_prager.hpp"
#include "material/equation_of_state.hpp"
#include "material/failure.hpp"
#include "material/fluid.hpp"
#include "material/johnson_cook.hpp"
#include "material/johnson_holmquist.hpp"
#include "material/material_state.hpp"
#include "material/mooney_rivlin.hpp"
#include "material/ogden.hpp"
#include "material/orthotropic.hpp"
#include "material/von_mises.hpp"
#include "material/yield_curve.hpp"

/// What an element kernel (element_update.hpp) works on: arrays of elements and nodes, constants of their material, and
/// the features for which it is compiled.
namespace pinball {

enum class YieldLaw {
  linear,  ///< of MaterialConstants (material.hpp)
  general  ///< and all else: back stress, curves, rates, heat, equations of state (material/general_material.hpp)
};

struct ElementFeatures {
  bool plastic;         ///< von Mises plasticity; else elastic, without plastic strain
  bool erosion;         ///< elements may be eroded; keeps an internal energy per element, where there is a place for it
  bool bulk_viscosity;  ///< may have it: its coefficients decide
  HourglassKind hourglass;
  YieldLaw yield = YieldLaw::linear;  ///< plastic only
  /// Else packs with corners that may fold are left as they are, and the material has to yield where it may. Calls of
  /// what is rare cost a device numbers that find no register, also where they are not made.
  bool rare_cases = true;
  bool tetrahedra = false;  ///< of tetrahedron_update.hpp
};

/// Element arrays in rows of L elements: entry c of element e is at [(e / L) * N + c] * L + e % L for an array of N
/// components. L is the width of a pack where packs work them, and 32 where threads of a device do, lane after lane of
/// a warp. All aligned to the row. Padding elements repeat the nodes of a real one and have mass 0; their other state
/// is never used.
template <class S>
struct ElementView {
  const std::int32_t* corner;  ///< N = 8: node numbers
  S* mass;                     ///< N = 1: of the material [mass]; 0 marks padding and eroded elements
  S* stress;                   ///< N = 6: xx yy zz xy yz zx [stress]
  S* plastic_strain;           ///< N = 1, plastic only [-]
  S* hourglass_state;          ///< N = 12, missing without hourglass control: of KeptHourglass [stress], or forces
  S* viscous_stress;           ///< N = 1: bulk viscosity of the previous step, bulk_viscosity only [stress]
  S* internal_energy;          ///< N = 1, erosion only; may be missing where nothing erodes [energy]
  /// N = material_numbers: what laws of materials keep from step to step, each in its place (MaterialPlaces); general
  /// yield only, and may be missing there
  S* material_state = nullptr;
  /// N = 1: `mass` over the mass with which the element's nodes move; missing: they are the same [-]
  const S* mass_share = nullptr;
  const S* folding_onset = nullptr;  ///< N = 1: of its corners (folding.hpp); missing: folding_onset [-]
  int material_numbers = 0;          ///< of one element in material_state
  S* volume_ratio = nullptr;         ///< N = 2, averaged_volumes only: J of averaged_step.hpp now, a step ago [-]
};

/// Node records of four scalars (gather.hpp).
template <class S>
struct NodeView {
  const S* position;
  const S* velocity;
  S* force;
};

/// Of hourglass control, in whatever form.
template <class S>
struct HourglassConstants {
  S coefficient;                          ///< k of the viscous form [-]
  S modulus;                              ///< kappa M of the stiffness form [stress]
  AssumedStrainModuli<S> assumed_strain;  ///< of that form
};

template <class S>
struct ElementConstants {
  MaterialConstants<S> material;
  HourglassConstants<S> hourglass;
  ViscosityConstants<S> viscosity;
  FailureConstants<S> failure;
  S specific_volume;          ///< 1/density of the undeformed material [length^3/mass]
  S folding_energy = S(0);    ///< M/(8 density) of corners that are about to turn over [energy/mass]
  bool never_yields = false;  ///< elastic, also where the kernel is one of plasticity (with erosion)
  // General yield only:
  bool averaged_volumes = false;  ///< of tetrahedra and wedges: over nodes (element/averaged_step.hpp)
  HardeningConstants<S> hardening{};
  JohnsonCookConstants<S> johnson_cook{};  ///< in the place of `hardening`, where used
  JohnsonHolmquistConstants<S> brittle{};  ///< in the place of `hardening` and of the linear pressure, where used
  DruckerPragerConstants<S> granular{};    ///< in the place of `hardening`, where used
  CrushableFoamConstants<S> foam{};        ///< where used `hardening` has its curve over the compaction
  MooneyRivlinConstants<S> rubber{};       ///< of what never yields, in the place of Hooke's law, where used
  OgdenConstants<S> ogden{};               ///< the same
  OrthotropicConstants<S> orthotropic{};   ///< the same
  FluidConstants<S> fluid{};               ///< in the place of all strength, where used
  EquationOfState<S> pressure{};
  MaterialPlaces places{};
};

/// Where element `first`, the first of a pack, has its component 0 in an array of n components in rows of L.
template <int L>
PINBALL_FUNCTION std::int64_t place_in_rows(std::int64_t first, int n) {
  return first / L * L * n + first % L;
}

/// The step that elements have just made.
template <class S>
struct ElementStep {
  S length;      ///< since they were updated before [time]
  S weight = 1;  ///< of their forces: how many steps of their nodes they act for, where these are shorter [-]
  S time = 0;    ///< at its end [time]
};

}  // namespace pinball
