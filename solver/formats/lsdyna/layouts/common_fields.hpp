#pragma once

#include <solver/formats/deck/card_field.hpp>

/// What cards of several headers have in common: fields, and reasons why one is not used.
namespace pinball::layout {

inline constexpr std::string_view no_rotations = "nodes of solids have no rotations",
                                  of_thermal = "heat is not computed", of_shells = "of shells", of_beams = "of beams",
                                  no_splines = "there are no splines",
                                  as_they_are = "curves are taken as they are, at each of their points";

constexpr CardField rotation(std::string_view name) { return number(name).reported(no_rotations); }

/// Nodes, solids, parts or sets of a list.
inline constexpr CardLayout members{whole("ID1"), whole("ID2"), whole("ID3"), whole("ID4"),
                                    whole("ID5"), whole("ID6"), whole("ID7"), whole("ID8")};

}  // namespace pinball::layout
