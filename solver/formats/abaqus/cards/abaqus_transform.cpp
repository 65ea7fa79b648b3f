#include "abaqus_transform.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/formats/deck/direction_names.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

Point unit_along(const Point& vector, const AbaqusBlock& block, const char* expected) {
  const double length = norm(vector);
  if (!(length > 0)) fail_at(block.place, fmt::format("*TRANSFORM: expected {}", expected));
  return {vector[0] / length, vector[1] / length, vector[2] / length};
}

}  // namespace

AbaqusTransforms::AbaqusTransforms(AbaqusData& data) : data_(data) {
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "TRANSFORM") read(block);
  }
}

/// Of R the first point lies on the first axis, and the second in the plane of the first two; of C both on the axis.
void AbaqusTransforms::read(const AbaqusBlock& block) {
  const std::string type = block.option("TYPE");
  if (!block.part.empty() || !block.instance.empty())
    return data_.report.reject(block.place, "*TRANSFORM in a part or an instance", "move it into *ASSEMBLY");
  if (type == "S") return data_.report.reject(block.place, "*TRANSFORM, TYPE=S", "R and C are done");
  DataLines lines(block);
  const DataLine card = lines.require("two points");
  const DataFields f(card);
  Point a{}, b{};
  for (std::size_t k = 0; k < 3; ++k) {
    a[k] = f.number(k, "first point", 0.0);
    b[k] = f.number(3 + k, "second point", 0.0);
  }
  AbaqusTransform transform{&block, type == "C"};
  if (transform.is_cylindrical) {
    transform.axes[2] = unit_along(minus(b, a), block, "two points of an axis");
    transform.axis = {a, transform.axes[2]};
  } else {
    const Point first = unit_along(a, block, "a point on the first axis"),
                third = unit_along(cross(first, b), block, "a second point that is not on the first axis");
    transform.axes = {first, cross(third, first), third};
  }
  transform.nodes = data_.nodes(block.require("NSET"), block.place).members;
  transforms_.push_back(std::move(transform));
}

const AbaqusTransform* AbaqusTransforms::of(const AbaqusNodes& nodes, const AbaqusBlock& block,
                                            const DeckPlace& place) const {
  const AbaqusTransform* found = nullptr;
  std::size_t with = 0;
  for (const AbaqusTransform& transform : transforms_) {
    const auto own = std::ranges::count_if(
        nodes.members, [&](std::int32_t node) { return std::ranges::binary_search(transform.nodes, node); });
    if (own > 0 && found != nullptr) {
      data_.report.reject(place, block.star_name() + " of nodes with more than one *TRANSFORM",
                          "give each its own line");
      return nullptr;
    }
    if (own > 0) found = &transform;
    with += own;
  }
  if (found != nullptr && with < nodes.members.size())
    data_.report.reject(place, block.star_name() + " of nodes of which some have a *TRANSFORM",
                        "give those with it a line of their own");
  return found;
}

Point AbaqusTransforms::direction(const AbaqusTransform* transform, std::size_t degree, const AbaqusBlock& block,
                                  const DeckPlace& place) const {
  Point direction{};
  direction[degree] = 1;
  if (transform == nullptr) return direction;
  if (transform->is_cylindrical && degree < 2)
    data_.report.reject(place, block.star_name() + " along directions that differ from node to node",
                        "of *TRANSFORM, TYPE=C the axial one is done, and all of what is held");
  return transform->axes[degree];
}

void set_directions(unsigned bits, const AbaqusTransform* transform, const DeckKeys<FixedConstraint>& keys) {
  if (transform == nullptr) {
    keys.set("directions", direction_names(bits));
    return;
  }
  std::vector<std::string> names;
  std::vector<Point> axes;
  for (std::size_t k = 0; k < 3; ++k) {
    if ((bits >> k & 1U) == 0) continue;
    static constexpr std::array cylindrical{"radial", "circumferential", "axial"};
    names.emplace_back(cylindrical[k]);
    axes.push_back(transform->axes[k]);
  }
  if (!transform->is_cylindrical) {
    keys.set("directions", axes);
    return;
  }
  keys.set("frame", "cylindrical");
  keys.set("directions", names);
  InnerKeys<Line> axis;
  axis.set("point", transform->axis.point);
  axis.set("direction", transform->axis.direction);
  keys.set("axis", axis.value());
}

}  // namespace pinball
