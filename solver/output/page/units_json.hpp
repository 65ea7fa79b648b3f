#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include <solver/scene/units/units.hpp>

namespace pinball {

/// Names of the units by quantity; empty where the scene does not name them.
nlohmann::ordered_json units_json(const Units& units);

/// The name of a unit of T, L and M, as SceneEntry has it; what is none of these ("degree") stays, "-" and what the
/// scene does not name is empty.
std::string unit_of(const std::string& dimension, const Units& units);

}  // namespace pinball
