#include <solver/scene/schema/contact.hpp>
#include <solver/scene_rules.hpp>

#include "entries.hpp"
#include "list_keys.hpp"

namespace pinball {

std::string toml_text(const ContactSide& side) {
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

void list_contact_parts(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const ContactPair& pair : scene.contact_pairs) {
    Entries table(all, "contact.pair." + pair.name);
    ContactPair without;
    complete(without, scene.contact);
    list_keys(table, pair, without);
  }
  for (const TiedContact& tied : scene.tied_contacts) {
    Entries table(all, "contact.tied." + tied.name);
    list_keys(table, tied);
  }
}

}  // namespace pinball
