#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <solver/formats/radioss/layouts/radioss_material_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// /DEF_SOLID: what holds where a property leaves it 0.
struct DefaultSolid {
  std::int64_t form = 1, strains = 4;
};

DefaultSolid read_default(RadiossData& data) {
  DefaultSolid solid;
  const RadiossBlock* block = data.last("DEF_SOLID");
  if (block == nullptr) return solid;
  RadiossLines lines(*block);
  const DataLine line = lines.next_or_blank();
  const RadiossFields f(line, *block, radioss::default_solid);
  if (f.integer("Isolid") != 0) solid.form = f.integer("Isolid");
  if (f.integer("Ismstr") != 0) solid.strains = f.integer("Ismstr");
  return solid;
}

bool is_fully_integrated(std::int64_t form) {
  return form == 12 || form == 13 || form == 14 || form == 16 || form == 17 || form == 18 || form == 19;
}

/// Of a /PROP/SOLID; 0 is the default, as of the starter.
DeckElement element_of(RadiossData& data, const RadiossBlock& block, int solids, const DefaultSolid& otherwise) {
  RadiossLines lines(block);
  const DataLine first = lines.next_or_blank(), second = lines.next_or_blank(), third = lines.next_or_blank();
  const RadiossFields f(first, block, radioss::solid), v(second, block, radioss::solid_viscosity),
      s(third, block, radioss::solid_step);
  const auto number = [&](const char* name, double default_) {
    const double given = v.number(name);
    return given == 0 ? default_ : given;
  };
  const std::int64_t form = f.integer("Isolid") == 0 ? otherwise.form : f.integer("Isolid"),
                     strains = f.integer("Ismstr") == 0 ? otherwise.strains : f.integer("Ismstr");
  const bool small = strains == 1 || strains == 3 || strains == 11;
  if (small)
    data.report.reject(first.place, fmt::format("{} with Ismstr {}, small strains", block.title, strains),
                       "give 2 or 4: strains are large ones", solids);
  if (!small && strains != 4)
    data.report.unused(first.place, fmt::format("{}: Ismstr {}", block.title, strains), "strains are large ones");
  DeckElement element{"assumed_strain", 1.0, number("qa", 1.1), number("qb", 0.05)};
  const double h = number("h", 0.1);
  if (form == 1 || form == 2) {
    element.hourglass = "viscous";
    element.coefficient = h / 4;
    data.report.understood(fmt::format("{} ({}): hourglass control is viscous, the same for Isolid 1 and 2",
                                       block.title, block.place.text()));
    return element;
  }
  if (form != 24 && !is_fully_integrated(form)) {
    data.report.reject(first.place, fmt::format("{} with Isolid {}", block.title, form),
                       "1, 2, 12, 14, 16, 17, 18 and 24 are read", solids);
    return element;
  }
  if (!v.blank("h") && v.number("h") != 0)
    data.report.unused(second.place, block.title + ": h", "elements of assumed strain need none");
  data.report.understood(fmt::format("{} ({}): Isolid {} as elements of assumed strain, with one point{}", block.title,
                                     block.place.text(), form, form == 24 ? "" : " in the place of full integration"));
  return element;
}

}  // namespace

std::vector<DeckElement> radioss_elements(RadiossData& data) {
  const DefaultSolid otherwise = read_default(data);
  std::map<std::int64_t, DeckElement> of_property;
  GivenOnce given;
  for (const RadiossBlock& block : data.deck.blocks) {
    if (!block.name.starts_with("PROP/")) continue;
    given.add(fmt::format("property {}", block.id()), block.place);
    int solids = 0;
    for (const RadiossBody& body : data.bodies) solids += body.part.property == block.id() ? body.solids : 0;
    const bool joint = block.name == "PROP/KJOINT2";
    if (joint && solids > 0) data.report.reject(block.place, block.title + " of solids", "give /PROP/SOLID", solids);
    if (joint && solids == 0 && is_property_of_springs(data, block.id())) continue;
    if (solids == 0) {
      data.report.unused(block.place, fmt::format("{}, which no part with solids has", block.title));
      if (block.log != nullptr) block.log->done(&block);
    } else if (block.name == "PROP/SOLID") {
      of_property[block.id()] = element_of(data, block, solids, otherwise);
    } else {
      of_property[block.id()] = {};  // of shells that do not deform, or refused elsewhere
    }
  }
  std::vector<DeckElement> elements;
  for (const RadiossBody& body : data.bodies) {
    const auto found = of_property.find(body.part.property);
    if (found == of_property.end())
      fail_at(body.part.place, fmt::format("no /PROP has the number {}", body.part.property));
    elements.push_back(found->second);
  }
  // What does not deform has no other elements than the rest.
  const auto deforms = std::ranges::find(data.bodies, false, &RadiossBody::is_of_shells);
  if (deforms == data.bodies.end()) return elements;
  for (std::size_t b = 0; b < elements.size(); ++b) {
    if (data.bodies[b].is_of_shells) elements[b] = elements[deforms - data.bodies.begin()];
  }
  return elements;
}

void translate_radioss_bodies(const RadiossData& data, const std::string& mesh_file, DeckScene& scene) {
  for (std::size_t b = 0; b < data.bodies.size(); ++b) {
    const RadiossBody& body = data.bodies[b];
    const auto keys = scene.entry<Body>("body", {"/PART/" + std::to_string(body.part.id), body.part.place});
    keys.comment("");
    keys.set("name", body.name);
    keys.set("material", fmt::format("mat_{}", body.part.material), "mat_ID");
    InnerKeys<FileMesh> mesh;
    mesh.set("type", "radioss");
    mesh.set("file", mesh_file);
    mesh.set("part", std::to_string(body.part.id));
    keys.set("mesh", mesh.value());
    if (data.elements[b] != data.elements.front()) set_body_element(data.elements[b], keys);
  }
}

}  // namespace pinball
