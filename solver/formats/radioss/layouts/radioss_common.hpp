#pragma once

#include <solver/formats/deck/card_field.hpp>

/// Lines of Radioss input: whole numbers and words have ten columns, numbers twenty. What several headers have in
/// common.
namespace pinball::radioss {

using layout::whole;

constexpr CardField real(std::string_view name, double otherwise = 0) {
  return layout::number(name, otherwise).columns(20);
}
constexpr CardField word(std::string_view name, std::string_view otherwise = {}) {
  return layout::text(name, otherwise);
}
constexpr CardField blank(int columns) { return layout::gap.columns(columns); }

inline constexpr std::string_view no_sensors = "there are no sensors: leave it 0", of_shells = "of shells",
                                  of_heat = "heat is not computed", no_penalty = "contact has no penalty stiffness",
                                  no_gap = "faces lie where their nodes are",
                                  all_checked = "the search finds all pairs by itself",
                                  own_units = "write it in the units of /BEGIN";

constexpr CardField sensor(std::string_view name) { return whole(name).rejected(no_sensors); }

/// Nodes, elements, parts or groups of a list.
inline constexpr CardLayout members{whole("item_ID1"), whole("item_ID2"), whole("item_ID3"), whole("item_ID4"),
                                    whole("item_ID5"), whole("item_ID6"), whole("item_ID7"), whole("item_ID8"),
                                    whole("item_ID9"), whole("item_ID10")};

}  // namespace pinball::radioss
