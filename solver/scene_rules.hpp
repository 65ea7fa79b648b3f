#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/export.h"
#include "scene.hpp"

/// What a scene has to fulfil beyond what each key says for itself (scene/schema), and the defaults that depend on
/// other values: one place for scenes read from files and for those that a host makes.
namespace pinball {

/// What is wrong under a key of a table; whoever asks knows where the table is.
struct Problem {
  std::string key;
  std::string text;  ///< "expected ..., got ..."
};

/// Fills in what is not set and follows from other settings.
void complete(ElementSettings& element);
void complete(ContactSettings& contact);
/// contact: completed.
void complete(ContactPair& pair, const ContactSettings& contact);
/// The yield stress of a material with yield curves: where the first begins.
void complete(Material& material);
/// The same for the whole scene; also brings normals and directions to unit length. A second call changes nothing.
PINBALL_API void complete_scene(Scene& scene);

/// Of completed settings.
std::optional<Problem> problem_of(const TimeSettings& time);
std::optional<Problem> problem_of(const ContactSettings& contact);
/// contact: for what is common to all pairs.
std::optional<Problem> problem_of(const ContactPair& pair, const ContactSettings& contact);
std::optional<Problem> problem_of(const TiedContact& tied);
/// yield_stress is given for an elastic material, too, which does not use it; 0: not given.
std::optional<Problem> problem_of(const Material& material);
/// Of a material that needs other elements than the body has.
std::optional<Problem> problem_of(const Body& body, const Scene& scene);
std::optional<Problem> problem_of(const YieldCurve& curve);
std::optional<Problem> problem_of(const JohnsonCookSettings& law);
/// bulk_modulus: of the material.
std::optional<Problem> problem_of(const JohnsonHolmquistSettings& law, double bulk_modulus);
std::optional<Problem> problem_of(const DruckerPragerSettings& law);
std::optional<Problem> problem_of(const CrushableFoamSettings& law);
std::optional<Problem> problem_of(const OgdenSettings& law);
/// Of small strains: half the sum of moduli times exponents [stress].
double shear_modulus_of(const OgdenSettings& law);
std::optional<Problem> problem_of(const OrthotropicSettings& law);
std::optional<Problem> problem_of(const EquationOfStateSettings& eos);
std::optional<Problem> problem_of(const ErosionSettings& erosion);
/// Whether its elements are eroded where their damage reaches 1.
bool erodes_by_damage(const Material& material);
/// Whether its elements may be eroded for a reason of the material's.
bool erodes(const Material& material);
/// The slope of the pressure over the compression there [stress]; 0 of settings that are none.
double bulk_modulus_at_rest(const EquationOfStateSettings& eos, double density);
std::optional<Problem> problem_of(const TimeTable& table);
std::optional<Problem> problem_of(const TimeSpan& when);
std::optional<Problem> problem_of(const EquationTerm& term);
std::optional<Problem> problem_of(const RigidWall& wall);
std::optional<Problem> problem_of(const Box& box);
/// Of one by itself, and beside the rest of the scene.
std::optional<Problem> problem_of(const RigidBody& rigid);
std::optional<Problem> problem_of(const RigidBody& rigid, const Scene& scene);
std::optional<Problem> problem_of(const RigidMotion& motion);
std::optional<Problem> problem_of(const Joint& joint);
std::optional<Problem> problem_of(const Joint& joint, const Scene& scene);

/// Names are parts of dotted keys and of column headings: letters, digits, "_" and "-" only.
std::optional<Problem> name_problem(const std::string& name);
/// A vector without a direction.
std::optional<Problem> direction_problem(std::string_view key, const Point& vector);

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

/// Completes a scene and checks all of it but the meshes. Throws InputError: "KEY: expected ..., got ...", the key with
/// its table as in --set ("material.copper.density").
PINBALL_API Scene checked_scene(Scene scene);

}  // namespace pinball
