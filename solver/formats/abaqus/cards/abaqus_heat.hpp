#pragma once

#include <string>
#include <vector>

#include "abaqus_data.hpp"

/// What heat does to a material of Abaqus input: plastic work warms it where *DYNAMIC is ADIABATIC, and it softens
/// (HARDENING=JOHNSON COOK) and expands.
namespace pinball {

/// Whether plastic work warms materials: a step is ADIABATIC, or of DYNAMIC TEMPERATURE-DISPLACEMENT.
bool is_adiabatic(const AbaqusDeck& deck);
/// Refuses a deck of which some steps warm a material, and others do not.
void require_heat_in_all_steps(AbaqusData& data);

/// The options of a material that say what heat does; null: it has none.
struct AbaqusHeat {
  const AbaqusBlock* specific_heat = nullptr;
  const AbaqusBlock* share = nullptr;  ///< INELASTIC HEAT FRACTION
  const AbaqusBlock* expansion = nullptr;
  const AbaqusBlock* conductivity = nullptr;
};

/// Temperature of a material at the start, from INITIAL CONDITIONS, TYPE=TEMPERATURE; 0 where nothing gives one. Where
/// it is not the same everywhere, it is refused.
double initial_temperature(AbaqusData& data, const std::string& material);

/// Heat capacity and share of plastic work that heats, of a plastic material in an ADIABATIC step. Throws InputError
/// where SPECIFIC HEAT is missing.
struct HeatConstants {
  double specific_heat = 0;  ///< [energy/(mass temperature)]
  double share = 0.9;        ///< [-]
};
HeatConstants heat_constants(const AbaqusHeat& heat, const DeckPlace& material);

/// Of DYNAMIC TEMPERATURE-DISPLACEMENT: heat stays where it is here, which is what the deck means where elements give
/// their neighbours next to nothing: k t/(rho c h^2), h the shortest edge. Tells how much, or refuses it. density: that
/// of the deck.
void require_little_flow(AbaqusData& data, const std::string& material, const AbaqusHeat& heat,
                         const HeatConstants& constants, double density);

/// The pressure of a material that expands as plastic work warms it (docs/decks.md): a polynomial equation of state in
/// the place of its bulk modulus. density: that of the deck.
EquationOfStateSettings expanding_pressure(const AbaqusHeat& heat, const HeatConstants& constants, double bulk_modulus,
                                           double density);

/// Says what of these does nothing.
void tell_unused_heat(AbaqusData& data, const AbaqusHeat& heat, const std::string& reason);
/// The same of temperatures at the start that initial_temperature has not been asked for.
void tell_unused_temperatures(AbaqusData& data);

}  // namespace pinball
