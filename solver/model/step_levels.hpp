#pragma once

#include <cstdint>
#include <vector>

#include "model.hpp"

/// Which elements make which steps where they may differ (time.subcycling): those of level l make steps of 2^l times
/// the smallest.
namespace pinball {

inline constexpr int highest_step_level = 6;

/// Elements that go together.
struct StepGroup {
  double stable_step = 0;  ///< smallest of its elements, infinite if there are none left [time]
  double elements = 0;
  int highest = highest_step_level;  ///< the level that it may not exceed
};

/// The step of level 0 that a choice of levels leaves: the smallest stable_step / 2^level [time].
double smallest_step(const std::vector<StepGroup>& groups, const std::vector<int>& levels);

/// Work per time: element steps, and `every_step` of them for what each smallest step costs however few elements
/// make it [1/time].
double work_per_time(const std::vector<StepGroup>& groups, const std::vector<int>& levels, double every_step);

/// The levels with the least work per time. The smallest step may come out smaller than the smallest stable step, where
/// that lets many elements on to the next level. The lowest level is 0.
std::vector<int> choose_levels(const std::vector<StepGroup>& groups, double every_step);

/// Levels of the elements of a mesh in its initial state.
struct ElementLevels {
  std::vector<std::uint8_t> own;    ///< by the stable step of the element itself
  std::vector<std::uint8_t> level;  ///< of the smallest step among the elements around its nodes: never above `own`
};

/// The nodal partition of Belytschko, Yen and Mullen (Comput. Meth. Appl. Mech. Engrg. 17/18, 259-275, 1979): a node
/// belongs to the smallest step of its elements, an element to the smallest step of its nodes. So around elements that
/// need a small step lies a layer that does not need it, and makes it all the same: without that layer the exchange of
/// impulses between the levels is unstable (a bar of which a sixth of the elements is eight times as fine gains energy
/// without bound within some hundred cycles, even at 0.7 of the stable step).
///
/// A node on which something else than elements may act (contact, rigid walls, loads, prescribed velocities, equations)
/// belongs to the smallest step too. With larger ones around it, it would be pushed by the elements in one step out of
/// several, and back by contact in the others. So do tetrahedra and wedges, of which the volumes are averaged over
/// nodes: all around a node have to be of one time.
///
/// mass_factor: of mass_factors (mass_scaling.hpp).
ElementLevels element_step_levels(const Scene& scene, const ModelMesh& mesh,
                                  const std::vector<double>& mass_factor = {});

/// Smallest of the stable steps of an element without viscosity, as the kernel finds it [time].
double element_stable_step(const Scene& scene, const ModelMesh& mesh, std::size_t element, const Material& material);

}  // namespace pinball
