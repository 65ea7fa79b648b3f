#include <cmath>

#include <solver/scene/entries.hpp>
#include <solver/scene_rules.hpp>

namespace pinball {

namespace {

std::string side_text(const ContactSide& side) {
  std::string text;
  const auto add = [&text](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
  const auto add_sets = [&add](const char* kind, const std::vector<MeshSetName>& sets) {
    for (const MeshSetName& set : sets) {
      add(fmt::format("{{ {} = {}{} }}", kind, toml_text(set.set),
                      set.file.empty() ? "" : ", file = " + toml_text(set.file)));
    }
  };
  for (const std::string& body : side.bodies) add(toml_text(body));
  add_sets("elements", side.elements);
  add_sets("faces", side.faces);
  add_sets("nodes", side.nodes);
  return fmt::format("[{}]", text);
}

void list_end(Entries& table, double end) {
  const bool none = !std::isfinite(end);
  table.add_words("end", none ? "none" : toml_text(end), none, "T");
}

}  // namespace

void list_contact_parts(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const ContactPair& pair : scene.contact_pairs) {
    Entries table(all, "contact.pair." + pair.name);
    table.add_words("first", side_text(pair.first), false);
    const bool alone = pair.second.empty();
    table.add_words("second", alone ? "first" : side_text(pair.second), alone);
    ContactPair without;
    complete(without, scene.contact);
    table.add_numbers(pair, without);
    list_end(table, pair.end);
  }
  for (const TiedContact& tied : scene.tied_contacts) {
    Entries table(all, "contact.tied." + tied.name);
    table.add_words("first", side_text(tied.first), false);
    table.add_words("second", side_text(tied.second), false);
    const bool none = tied.tolerance < 0;
    table.add_words("tolerance", none ? "0.05 of a face's shorter diagonal" : toml_text(tied.tolerance), none, "L");
    table.add_numbers(tied, {});
    list_end(table, tied.end);
  }
}

}  // namespace pinball
