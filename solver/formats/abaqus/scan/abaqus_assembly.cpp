#include "abaqus_assembly.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <solver/formats/deck/given_once.hpp>

namespace pinball {

InstancePlacement::InstancePlacement(const AbaqusBlock& instance) {
  DataLines lines(instance);
  if (const auto card = lines.next()) {
    const DataFields f(*card);
    for (std::size_t k = 0; k < 3; ++k) shift_[k] = f.number(k, "translation", 0.0);
    moves_ = true;
  }
  const auto card = lines.next();
  if (!card) return;
  const DataFields f(*card);
  Point axis{};
  for (std::size_t k = 0; k < 3; ++k) {
    origin_[k] = f.number(k, "axis", 0.0);
    axis[k] = f.number(3 + k, "axis", 0.0) - origin_[k];
  }
  const double length = norm(axis), angle = f.number(6, "angle", 0.0) * std::numbers::pi / 180;
  if (!(length > 0)) fail_at(card->place, "*INSTANCE: expected two different points of the axis");
  for (double& component : axis) component /= length;
  const double c = std::cos(angle), s = std::sin(angle);
  for (std::size_t i = 0; i < 3; ++i) {  // Rodrigues
    for (std::size_t j = 0; j < 3; ++j) rotation_[i][j] = (1 - c) * axis[i] * axis[j] + (i == j ? c : 0);
    rotation_[i][(i + 1) % 3] -= s * axis[(i + 2) % 3];
    rotation_[i][(i + 2) % 3] += s * axis[(i + 1) % 3];
  }
  turns_ = angle != 0;
}

Point InstancePlacement::apply(Point x) const {
  if (moves_) {
    for (std::size_t k = 0; k < 3; ++k) x[k] += shift_[k];
  }
  if (!turns_) return x;
  const Point arm = minus(x, origin_);
  for (std::size_t k = 0; k < 3; ++k) x[k] = origin_[k] + dot(rotation_[k], arm);
  return x;
}

namespace {

class Gatherer {
 public:
  explicit Gatherer(const AbaqusDeck& deck) : deck_(deck) {}

  std::vector<AbaqusComponent> gather() {
    for (const AbaqusBlock& block : deck_.blocks) {
      if (block.name == "PART") given_.add("part " + label_key(block.require("NAME")), block.place);
      sort_in(block);
    }
    for (const AbaqusBlock& block : deck_.blocks) {
      if (block.name == "INSTANCE") add_instance(block);
      if (block.name == "PART" && !assembly_) add_component(block, block.part);
    }
    std::vector<std::string> keys;
    for (const AbaqusComponent& component : components_) keys.push_back(component.key);
    tell_apart(components_, keys, &AbaqusComponent::name);
    components_.push_back(std::move(rest_));
    return std::move(components_);
  }

 private:
  void sort_in(const AbaqusBlock& block) {
    assembly_ |= block.assembly;
    if (!block.part.empty()) {
      parts_[block.part].push_back(&block);
    } else if (!block.instance.empty()) {
      own_[block.instance].push_back(&block);
    } else {
      rest_.blocks.push_back(&block);
    }
  }

  void add_instance(const AbaqusBlock& block) {
    const std::string part = label_key(block.require("PART"));
    if (!parts_.contains(part))
      fail_at(block.place, fmt::format("*INSTANCE: there is no *PART {}", *block.value("PART")));
    add_component(block, part);
    components_.back().placement = InstancePlacement(block);
    const auto& own = own_[block.instance];
    components_.back().blocks.insert(components_.back().blocks.end(), own.begin(), own.end());
  }

  void add_component(const AbaqusBlock& block, const std::string& part) {
    const std::string label = *block.value("NAME");
    if (block.name == "INSTANCE") instances_.add("instance " + label_key(label), block.place);
    components_.push_back({label_text(label), label_key(label), parts_[part], {}, block.place});
  }

  const AbaqusDeck& deck_;
  bool assembly_ = false;
  std::map<std::string, std::vector<const AbaqusBlock*>> parts_, own_;
  GivenOnce given_, instances_;
  AbaqusComponent rest_;
  std::vector<AbaqusComponent> components_;
};

}  // namespace

std::vector<AbaqusComponent> abaqus_components(const AbaqusDeck& deck) { return Gatherer(deck).gather(); }

std::vector<AbaqusSection> abaqus_sections(const std::vector<AbaqusComponent>& components, bool with_rigid) {
  std::vector<AbaqusSection> sections;
  std::vector<std::string> keys;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const std::size_t first = sections.size();
    for (const AbaqusBlock* block : components[c].blocks) {
      const bool is_rigid = with_rigid && block->name == "RIGIDBODY" && block->has("ELSET");
      if (block->name != "SOLIDSECTION" && !is_rigid) continue;
      const std::string label = block->require("ELSET");
      sections.push_back({c, block, label_text(label)});
      keys.push_back(label_key(label));
    }
    const AbaqusComponent& component = components[c];
    if (component.name.empty()) continue;
    const bool one = sections.size() == first + 1;
    for (std::size_t s = first; s < sections.size(); ++s) {
      sections[s].part = one ? component.name : component.name + '.' + sections[s].part;
      keys[s] = one ? component.key : component.key + '.' + keys[s];
    }
  }
  tell_apart(sections, keys, &AbaqusSection::part);
  std::set<std::string> taken;
  for (const AbaqusSection& section : sections) {
    if (!section.is_rigid()) taken.insert(section.part);
  }
  for (AbaqusSection& section : sections) {
    if (!section.is_rigid()) continue;
    while (!taken.insert(section.part).second) section.part += "_rigid";  // a set may be that of a section, too
  }
  return sections;
}

}  // namespace pinball
