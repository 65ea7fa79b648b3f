#include "contact_parts.hpp"

#include <fmt/format.h>

#include <solver/scene/schema/contact.hpp>

#include "read_keys.hpp"

namespace pinball {

namespace {

MeshSetName read_set(const SceneTable& table, std::string_view key) {
  return {table.text(key), table.has("file") ? table.text("file") : ""};
}

ContactSide read_side(const SceneTable& table, std::string_view key, const Names& bodies) {
  ContactSide side;
  const std::string expected =
      "names of bodies, { elements = \"SET\" }, { faces = \"SET\" } or { nodes = \"SET\" }, one or an array of them";
  for (const TextOrTable& member : table.texts_or_tables(key, "contact_side", expected)) {
    if (!member.table) {
      table.require_none(bodies.reference_problem(key, "body", member.text));
      side.bodies.push_back(member.text);
      continue;
    }
    const SceneTable& set = *member.table;
    int kinds = 0;
    for (auto [kind, list] : {std::pair{"elements", &side.elements}, {"faces", &side.faces}, {"nodes", &side.nodes}}) {
      if (!set.has(kind)) continue;
      list->push_back(read_set(set, kind));
      ++kinds;
    }
    if (kinds != 1) table.fail(key, fmt::format("expected {}", expected));
  }
  return side;
}

/// Of pairs and ties: their place for messages, their name, and what their keys say.
template <class Part>
void read_part(const SceneTable& table, const char* kind, std::size_t number, Part& part) {
  part.where = table.place();
  part.name = fmt::format("{}_{}", kind, number);
  read_keys(table, part);
}

}  // namespace

ContactPair read_contact_pair(const SceneTable& table, const Scene& scene, const Names& bodies) {
  ContactPair pair;
  read_part(table, "pair", scene.contact_pairs.size(), pair);
  pair.first = read_side(table, "first", bodies);
  table.require_none(column_problem(pair.name, bodies));
  if (table.has("second")) pair.second = read_side(table, "second", bodies);
  complete(pair, scene.contact);
  table.require_none(problem_of(pair, scene.contact));
  return pair;
}

TiedContact read_tied_contact(const SceneTable& table, const Scene& scene, const Names& bodies) {
  TiedContact tied;
  read_part(table, "tied", scene.tied_contacts.size(), tied);
  tied.first = read_side(table, "first", bodies);
  tied.second = read_side(table, "second", bodies);
  table.require_none(problem_of(tied));
  return tied;
}

}  // namespace pinball
