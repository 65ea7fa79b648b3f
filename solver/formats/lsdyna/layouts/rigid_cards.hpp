#pragma once

#include "definition_cards.hpp"

/// *MAT_RIGID, *CONSTRAINED_RIGID_BODIES.
namespace pinball::layout {

inline constexpr std::string_view not_coupled = "no other program moves bodies: leave it blank",
                                  own_system = "rigid bodies are written in the global system";
inline constexpr CardLayout rigid{material_id,
                                  density,
                                  young,
                                  poisson,
                                  number("N").rejected(not_coupled),
                                  number("COUPLE").rejected(not_coupled),
                                  number("M").rejected(not_coupled),
                                  text("ALIAS").rejected("bodies have the faces of their solids: leave it blank")};
inline constexpr CardLayout rigid_held{number("CMO").from(-1, 1), whole("CON1"), whole("CON2")};
inline constexpr CardLayout rigid_system{number("LCO").reported(own_system), number("A2").reported(own_system),
                                         number("A3").reported(own_system),  number("V1").reported(own_system),
                                         number("V2").reported(own_system),  number("V3").reported(own_system)};

inline constexpr CardLayout merged_parts{
    whole("PIDM").always(), whole("PIDS").always(),
    whole("IFLAG").reported("mass, centre and inertia are those of the nodes of all merged parts")};

}  // namespace pinball::layout
