#pragma once

#include <string>
#include <variant>

#include "../../scene.hpp"
#include "field_names.hpp"
#include "key.hpp"
#include "rigid.hpp"

/// The keys of the tables of which a scene has one, but for contact.
namespace pinball::schema {

template <class Visit>
constexpr void describe(Of<TimeSettings>, Visit&& visit) {
  using T = TimeSettings;
  visit(Key{"end",
            &T::end,
            "when the run stops; less than 2^52 steps, unless `steps` ends the run",
            {.unit = "T", .bound = positive, .need = Need::required}});
  visit(Key{"cfl",
            &T::cfl,
            "fraction of the stable time step",
            {.unit = "-", .bound = {.low = 0.0, .low_open = true, .high = 1.2}}});
  visit(Key{"steps",
            &T::steps,
            "stop after so many steps, at least 1; -1: no limit",
            {.bound = {.low = -1}, .unset = Unset::negative, .otherwise = "-1 (no limit)"}});
  visit(Key{"smallest_step",
            &T::smallest_step,
            "elements that would need a smaller step get so much mass that this one is stable (below); 0: none",
            {.unit = "T", .bound = not_negative}});
  visit(
      Key{"mass_scaling", &T::mass_scaling,
          "whose mass `smallest_step` changes: `\"small\"`: of elements that need it; `\"all\"`: mass is added to "
          "all, and taken from all, so that the step is that of each"}
          .idle_where([](const T& time, const Scene&) { return !(time.smallest_step > 0); }, "without smallest_step"));
  visit(Key{"subcycling", &T::subcycling,
            "elements that are stable with a larger step make one, 2, 4 ... 64 times the smallest (below)"});
}

/// Whether something holds of each body that has these settings: `[element]`, of which bodies take what they have not
/// themselves, or its own.
template <class Holds>
bool of_all_bodies(const ElementSettings& element, const Scene& scene, const Holds& holds) {
  for (const Body& body : scene.bodies) {
    const bool has = &element == &scene.element || (body.element && &*body.element == &element);
    if (has && !holds(body)) return false;
  }
  return true;
}
inline bool rigid_alone(const ElementSettings& element, const Scene& scene) {
  return of_all_bodies(element, scene, [&scene](const Body& body) { return is_rigid(body, scene); });
}
/// What a file has is not known here.
inline bool tetrahedra_alone(const ElementSettings& element, const Scene& scene) {
  return of_all_bodies(element, scene, [](const Body& body) {
    return body.elements == ElementShape::tetrahedra && !std::holds_alternative<FileMesh>(body.mesh);
  });
}
inline bool nothing_yields(const ElementSettings& element, const Scene& scene) {
  return of_all_bodies(element, scene, [&scene](const Body& body) {
    for (const Material& material : scene.materials) {
      if (material.name == body.material) return !material.plastic;
    }
    return false;
  });
}

template <class Visit>
constexpr void describe(Of<ElementSettings>, Visit&& visit) {
  using T = ElementSettings;
  const auto where_they_deform = [&visit](const auto& key) { visit(key.idle_where(rigid_alone, "of rigid bodies")); };
  where_they_deform(Key{"hourglass", &T::hourglass,
                        "hourglass control; `\"assumed_strain\"` resists as the material does in bending and twisting"}
                        .idle_where(tetrahedra_alone, "where all elements are tetrahedra"));
  where_they_deform(
      Key{"hourglass_coefficient",
          &T::hourglass_coefficient,
          "its strength; only beside `hourglass`. Viscous: QH/4 of other codes, whose QH = 0.1 is 0.025 here; a cube "
          "is stable up to 0.047 (`cfl` 0.9, Poisson ratio 0.3), and a warning at the start says where a scene is not",
          {.unit = "-",
           .bound = not_negative,
           .unset = Unset::negative,
           .otherwise = "0.05 stiffness, 0.025 viscous, 1 assumed strains"}}
          .idle_where([](const T& element, const Scene&) { return element.hourglass == HourglassControl::none; },
                      "beside hourglass = \"none\"")
          .idle_where(tetrahedra_alone, "where all elements are tetrahedra"));
  where_they_deform(
      Key{"bulk_viscosity", &T::bulk_viscosity, "artificial pressure that spreads shocks over a few elements"});
  where_they_deform(
      Key{"linear_viscosity", &T::linear_viscosity, "b1 of the bulk viscosity", {.unit = "-", .bound = not_negative}}
          .idle_where([](const T& element, const Scene&) { return !element.bulk_viscosity; },
                      "beside bulk_viscosity = false"));
  where_they_deform(Key{
      "quadratic_viscosity", &T::quadratic_viscosity, "b2 of the bulk viscosity", {.unit = "-", .bound = not_negative}}
                        .idle_where([](const T& element, const Scene&) { return !element.bulk_viscosity; },
                                    "beside bulk_viscosity = false"));
  where_they_deform(Key{"negative_volume",
                        &T::negative_volume,
                        "what happens to an element whose volume is not positive",
                        {.otherwise = "\"erode\" where a material erodes, else \"stop\""}});
  where_they_deform(
      Key{"inside_out", &T::inside_out,
          "what happens to an element with a corner that has turned over, whatever its volume: `\"warn\"`: it is "
          "counted, and reported at the end; `\"erode\"`; `\"stop\"` ends the run"});
  where_they_deform(
      Key{"folding_resistance",
          &T::folding_resistance,
          "modulus with which corners resist that are about to turn over, over the bulk modulus; 0: none does. It "
          "acts in materials that yield, where a corner has less than 0.3 of the mean of its element, and nowhere "
          "else",
          {.unit = "-", .bound = not_negative}}
          .idle_where(nothing_yields, "where no material of the elements yields")
          .idle_where(tetrahedra_alone, "where all elements are tetrahedra"));
}

template <class Visit>
constexpr void describe(Of<SkipSettings>, Visit&& visit) {
  using T = SkipSettings;
  visit(Key{"contact_search", &T::contact_search,
            "lists of what may touch last while `contact.skin` allows it; `false`: search at every step"});
  visit(Key{"resting", &T::resting,
            "tiles of up to 2,048 elements without stress whose nodes all have one velocity are not updated until "
            "something changes that; `false`: they are, with the same bits"}
            .idle_where([](const T&, const Scene& scene) { return scene.time.subcycling; }, "beside time.subcycling"));
}

template <class Visit>
constexpr void describe(Of<GuardSettings>, Visit&& visit) {
  using T = GuardSettings;
  visit(Key{"energy_error",
            &T::energy_error,
            "the run stops when the error of the energy balance, over the energy in motion in the frame of the scene's "
            "own centre of mass, exceeds this",
            {.unit = "-", .bound = positive}});
  visit(Key{"time_step_collapse",
            &T::time_step_collapse,
            "the run stops when the stable step is below this times its largest",
            {.unit = "-", .bound = {.low = 0.0, .high = 1.0}}});
}

template <class Visit>
constexpr void describe(Of<DampingSettings>, Visit&& visit) {
  visit(Key{"mass",
            &DampingSettings::mass,
            "a in the force -a m v on every node: for quasi-static problems; a = 2 w damps motion of circular "
            "frequency w critically; at most 2 over the stable step",
            {.unit = "1/T", .bound = not_negative}});
}

template <class Visit>
constexpr void describe(Of<OutputSettings>, Visit&& visit) {
  using T = OutputSettings;
  visit(Key{"interval",
            &T::interval,
            "between rows of `history.csv`; 0: 200 rows over the run; `\"step\"`, and less than a step: a row per step",
            {.unit = "T", .bound = not_negative, .done = Done::by_hand, .also = "step"}});
  visit(Field{"every_step", &T::every_step, "interval = \"step\""});
  visit(Key{"field_interval",
            &T::field_interval,
            "between field outputs; 0: none; less than a step: in every step",
            {.unit = "T", .bound = not_negative}});
  visit(Key{"field_times",
            &T::field_times,
            "field output at these times, in any order; later than `time.end`: none",
            {.unit = "T", .bound = not_negative}}
            .idle_where([](const T& output, const Scene& scene) { return output.field_times.front() > scene.time.end; },
                        "where all lie after time.end"));
  visit(Key{"fields", &T::fields, "which of them", {.texts = field_names}}.idle_where(
      [](const T& output, const Scene&) { return !(output.field_interval > 0) && output.field_times.empty(); },
      "without field_interval or field_times"));
  visit(Key{"body_energies", &T::body_energies,
            "energies, momentum and mass of each body in `history.csv`, after all other columns"});
}

}  // namespace pinball::schema
