#include "last_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <solver/base/point.hpp>
#include <solver/formats/deck/number_text.hpp>

#include "curve_difference.hpp"

namespace pinball {

namespace {

constexpr double same_time = 1e-5;  ///< of a time that is printed with few digits, over the time [-]

std::optional<std::size_t> place_of(const LastState& state, std::int64_t number) {
  const auto found = std::ranges::lower_bound(state.numbers, number);
  if (found == state.numbers.end() || *found != number) return std::nullopt;
  return found - state.numbers.begin();
}

/// The curves of the three components of a vector; null: there is none.
using Components = std::array<const OtherCurve*, 3>;

std::map<std::int64_t, Components> vectors_of(const OtherHistory& other, std::string_view quantity) {
  std::map<std::int64_t, Components> vectors;
  for (const OtherCurve& curve : other.curves) {
    const auto of = numbered_quantity(curve.name);
    if (!of || of->of_element || of->quantity.size() != quantity.size() + 2 || !of->quantity.starts_with(quantity))
      continue;
    const auto component = std::string_view("xyz").find(of->quantity.back());
    if (component != std::string_view::npos) vectors[of->number][component] = &curve;
  }
  std::erase_if(vectors, [](const auto& one) { return std::ranges::count(one.second, nullptr) > 0; });
  return vectors;
}

}  // namespace

std::optional<NumberedQuantity> numbered_quantity(std::string_view name) {
  for (const auto& [prefix, of_element] : {std::pair{std::string_view("node_"), false}, {"element_", true}}) {
    if (!name.starts_with(prefix)) continue;
    const std::string_view rest = name.substr(prefix.size());
    const auto end = rest.find('_');
    if (end == std::string_view::npos) return std::nullopt;
    const auto number = deck_integer(rest.substr(0, end));
    if (!number) return std::nullopt;
    return NumberedQuantity{of_element, *number, rest.substr(end + 1)};
  }
  return std::nullopt;
}

LastState last_state(const FieldSnapshot& snapshot, const FieldBase& base) {
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  for (std::size_t n = 0; n < base.node_number.size(); ++n) {
    if (base.node_number[n] >= 0) order.emplace_back(base.node_number[n], n);
  }
  std::ranges::sort(order);
  LastState state{snapshot.time, {}, {}, {}};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& [number, node] = order[i];
    const bool twice =
        (i > 0 && order[i - 1].first == number) || (i + 1 < order.size() && order[i + 1].first == number);
    if (twice) continue;
    state.numbers.push_back(number);
    state.displacements.push_back(minus(snapshot.position[node], base.initial[node]));
    state.velocities.push_back(snapshot.velocity[node]);
  }
  return state;
}

std::vector<StateDifference> state_differences(const LastState& here, const OtherHistory& other) {
  const double behind = here.time - other.times.back();
  if (here.time < other.times.front() || behind > same_time * here.time) return {};
  const double time = std::min(here.time, other.times.back());
  std::vector<StateDifference> all;
  for (const auto& [quantity, vectors] :
       {std::pair{"displacement", &here.displacements}, {"velocity", &here.velocities}}) {
    StateDifference d;
    d.quantity = quantity;
    double longest = -1, squares = 0;
    for (const auto& [number, components] : vectors_of(other, quantity)) {
      const auto place = place_of(here, number);
      if (!place) continue;
      Point there;
      for (std::size_t k = 0; k < 3; ++k) there[k] = value_between(other.times, components[k]->values, time);
      const double size = norm(there), difference = norm(minus((*vectors)[*place], there));
      if (!std::isfinite(difference)) continue;
      ++d.nodes;
      squares += difference * difference;
      d.scale = std::max(d.scale, size);
      if (difference <= longest) continue;
      longest = difference;
      d.largest_node = number;
    }
    if (d.nodes == 0) continue;
    if (d.scale > 0) {
      d.largest = longest / d.scale;
      d.root_mean_square = std::sqrt(squares / static_cast<double>(d.nodes)) / d.scale;
    }
    all.push_back(d);
  }
  return all;
}

}  // namespace pinball
