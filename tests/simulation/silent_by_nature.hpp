#pragma once

#include <algorithm>
#include <array>
#include <string_view>

/// Keys that change nothing in the small scenes of key_effects_scenes.hpp and are right to be silent.
namespace pinball::test {

struct SilentByNature {
  std::string_view kind;  ///< of table; empty: any
  std::string_view key;   ///< empty: any
  std::string_view because;
};

inline constexpr std::string_view same_nodes = "it selects the same nodes", not_reached = "nothing comes that far",
                                  in_less_time = "the same bits in another time",
                                  skipped = "info says that it is skipped", a_name = "a name",
                                  unchanged = "the value that it has", written = "what is written, and when";

inline constexpr auto all_silent_by_nature = std::to_array<SilentByNature>({
    {"", "name", a_name},
    {"scene", "title", a_name},
    {"time", "mass_scaling", "all elements need mass"},
    {"time", "cfl", "no element limits the step: all are rigid"},
    {"element", "hourglass", "nothing deforms, or it is that of the scene"},
    {"element", "quadratic_viscosity", "nothing deforms"},
    {"element", "negative_volume", not_reached},
    {"element", "inside_out", not_reached},
    {"element", "folding_resistance", not_reached},
    {"contact that is off", "", "it is off"},
    {"contact", "overlap", "no bodies overlap"},
    {"contact", "self", "no body touches itself"},
    {"contact", "method", "it is the one that is decided"},
    {"contact", "friction", "nothing slides"},
    {"contact", "static_friction", "nothing slides"},
    {"contact", "search", in_less_time},
    {"contact", "skin", in_less_time},
    {"skip", "", in_less_time},
    {"guard", "", not_reached},
    {"output", "interval", written},
    {"output", "field_interval", written},
    {"output", "field_times", written},
    {"contact_pair", "", "a body that does not touch itself"},
    {"contact_tied", "tolerance", same_nodes},
    {"body", "element", "nothing moves"},
    {"material", "model", "nothing yields"},
    {"material", "yield_stress", "nothing yields"},
    {"material", "power_hardening", unchanged},
    {"material", "yield_curve", unchanged},
    {"material", "erosion_strain", not_reached},
    {"material", "ultimate_stress", not_reached},
    {"erosion", "", not_reached},
    {"equation_of_state", "tension_limit", not_reached},
    {"equation_of_state", "full_compaction", not_reached},
    {"drucker_prager", "tension_limit", not_reached},
    {"elastic material", "yield_stress", skipped},
    {"elastic material", "plastic_modulus", skipped},
    {"elastic material", "ultimate_stress", skipped},
    {"elastic material", "erosion_strain", skipped},
    {"elastic material", "yield_curve", skipped},
    {"elastic material", "yield_curves", skipped},
    {"elastic material", "rate_interpolation", skipped},
    {"elastic material", "strain_rate", skipped},
    {"elastic material", "rate_exponent", skipped},
    {"elastic material", "johnson_cook", skipped},
    {"elastic material", "drucker_prager", skipped},
    {"elastic material", "crushable_foam", skipped},
    {"keyword", "file", "a file with the same text"},
    {"plane", "normal", "a direction of another length"},
    {"axis", "direction", "a direction of another length"},
    {"box", "low", same_nodes},
    {"symmetry", "normal", "a direction of another length"},
    {"symmetry", "point", "a point of the same plane"},
    {"symmetry", "body", same_nodes},
    {"symmetry", "tolerance", same_nodes},
    {"fixed", "plane", same_nodes},
    {"fixed", "box", same_nodes},
    {"fixed", "tolerance", same_nodes},
    {"prescribed_velocity", "body", same_nodes},
    {"load", "nearest", same_nodes},
    {"load", "each", "one node"},
    {"gravity", "bodies", "all of them"},
    {"probe", "body", same_nodes},
    {"rigid_body", "held", "it does not move along it"},
    {"rigid_nodes", "plane", same_nodes},
    {"rigid_nodes", "box", same_nodes},
    {"rigid_nodes", "tolerance", same_nodes},
    {"rigid_wall", "normal", "a direction of another length"},
    {"rigid_wall", "body", "nothing else comes to it"},
    {"rigid_wall", "box", "nothing else comes to it"},
    {"rigid_wall", "start", "nothing comes to it meanwhile"},
    {"rigid_wall", "end", "nothing comes to it afterwards"},
});

inline const SilentByNature* silent_by_nature(std::string_view kind, std::string_view key) {
  const auto* const found = std::ranges::find_if(all_silent_by_nature, [&](const SilentByNature& one) {
    return (one.kind.empty() || one.kind == kind) && (one.key.empty() || one.key == key);
  });
  return found == all_silent_by_nature.end() ? nullptr : found;
}

}  // namespace pinball::test
