#include "watched_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <solver/model/model.hpp>

#include "last_state.hpp"

namespace pinball {

namespace {

constexpr std::size_t most_watched = 10;  ///< of a kind: each is some columns of the history and curves of the page

using Numbers = std::vector<std::pair<std::int64_t, std::int32_t>>;

/// What the others have and the file of the scene as well, in order, but for what is watched.
std::vector<std::int64_t> numbers_of_others(const std::vector<OtherHistory>& others, bool elements,
                                            const Numbers& known, const Scene& scene) {
  std::set<std::int64_t> numbers;
  for (const OtherHistory& other : others) {
    for (const OtherCurve& curve : other.curves) {
      if (const auto of = numbered_quantity(curve.name); of && of->of_element == elements) numbers.insert(of->number);
    }
  }
  for (const Probe& probe : scene.probes) {
    if (probe.number && (probe.kind == ProbeKind::element) == elements) numbers.erase(*probe.number);
  }
  std::erase_if(numbers, [&](std::int64_t number) {
    const auto found = std::ranges::lower_bound(known, number, {}, &Numbers::value_type::first);
    return found == known.end() || found->first != number || found->second < 0;
  });
  return {numbers.begin(), numbers.end()};
}

}  // namespace

std::vector<std::string> watch_numbers(const std::vector<OtherHistory>& others, Scene& scene) {
  const bool any = std::ranges::any_of(others, [](const OtherHistory& other) {
    return std::ranges::any_of(other.curves, [](const OtherCurve& c) { return numbered_quantity(c.name).has_value(); });
  });
  if (!any) return {};
  const ModelMesh mesh = build_mesh(scene);
  if (mesh.files.size() != 1) return {};
  std::vector<std::string> more;
  for (const bool elements : {false, true}) {
    const char* const kind = elements ? "element" : "node";
    const std::vector<std::int64_t> numbers =
        numbers_of_others(others, elements, elements ? mesh.files[0].element_numbers : mesh.files[0].numbers, scene);
    const std::size_t watched = std::min(numbers.size(), most_watched);
    for (std::size_t i = 0; i < watched; ++i) {
      const std::int64_t number = numbers[watched < 2 ? 0 : i * (numbers.size() - 1) / (watched - 1)];
      Probe probe;
      probe.name = fmt::format("{}_{}", kind, number);
      probe.kind = elements ? ProbeKind::element : ProbeKind::node;
      probe.number = number;
      probe.quantities = probe_quantities(probe.kind);
      scene.probes.push_back(probe);
    }
    if (watched < numbers.size())
      more.push_back(fmt::format("histories of {} of {} {}s that the other programs have by number", watched,
                                 numbers.size(), kind));
  }
  return more;
}

}  // namespace pinball
