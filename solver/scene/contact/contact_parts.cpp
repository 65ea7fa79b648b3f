#include "contact_parts.hpp"

#include <fmt/format.h>

namespace pinball {

namespace {

MeshSetName read_set(const SceneTable& table, std::string_view key) {
  return {table.text(key), table.text("file", "")};
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

/// When it begins and ends.
template <class Part>
void read_times(const SceneTable& table, Part& part) {
  if (table.has("end")) part.end = table.number("end", any_number);
}

std::string default_name(const SceneTable& table, const char* kind, std::size_t number) {
  return table.has("name") ? table.name("name") : fmt::format("{}_{}", kind, number);
}

}  // namespace

ContactPair read_contact_pair(const SceneTable& table, const Scene& scene, const Names& bodies) {
  ContactPair pair;
  pair.where = fmt::format("{}: {}", table.where(), table.path());
  pair.name = default_name(table, "pair", scene.contact_pairs.size());
  pair.first = read_side(table, "first", bodies);
  table.require_none(column_problem(pair.name, bodies));
  if (table.has("second")) pair.second = read_side(table, "second", bodies);
  table.numbers_into(pair);
  read_times(table, pair);
  complete(pair, scene.contact);
  table.require_none(problem_of(pair, scene.contact));
  return pair;
}

TiedContact read_tied_contact(const SceneTable& table, const Scene& scene, const Names& bodies) {
  TiedContact tied;
  tied.where = fmt::format("{}: {}", table.where(), table.path());
  tied.name = default_name(table, "tied", scene.tied_contacts.size());
  tied.first = read_side(table, "first", bodies);
  tied.second = read_side(table, "second", bodies);
  table.numbers_into(tied);
  if (table.has("tolerance")) tied.tolerance = table.number("tolerance", not_negative);
  read_times(table, tied);
  table.require_none(problem_of(tied));
  return tied;
}

}  // namespace pinball
