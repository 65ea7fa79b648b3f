#include "listing.hpp"

#include <span>

#include <solver/base/state_hash.hpp>
#include <solver/scene/schema/scene.hpp>
#include <solver/scene/without_keys.hpp>

#include "entries.hpp"
#include "list_keys.hpp"

namespace pinball {

std::string toml_text(const std::vector<std::int64_t>& numbers) {
  constexpr std::size_t most_written = 12;
  if (numbers.size() <= most_written) return fmt::format("[{}]", fmt::join(numbers, ", "));
  StateHash hash;
  hash.add(std::span<const std::int64_t>(numbers));
  return fmt::format("{} numbers, checksum {:016x}", numbers.size(), hash.value());
}

std::string toml_text(const std::vector<std::array<std::int64_t, 4>>& faces) {
  StateHash hash;
  for (const auto& face : faces) hash.add(std::span<const std::int64_t>(face));
  return fmt::format("{} faces, checksum {:016x}", faces.size(), hash.value());
}

namespace {

void list_top(const Scene& scene, std::vector<SceneEntry>& all) {
  Entries top(all, "");
  list_keys(top, scene);
  top.add_words("--refine", toml_text(scene.refine), scene.refine == 1);
}

/// Of which a scene has one.
template <class T>
void list_table(const char* name, const T& object, std::vector<SceneEntry>& all) {
  Entries table(all, name);
  list_keys(table, object);
}

void list_contact(const Scene& scene, std::vector<SceneEntry>& all) {
  Entries table(all, "contact");
  list_keys(table, scene.contact, without_keys(scene.contact));
}

void list_output(const Scene& scene, std::vector<SceneEntry>& all) {
  const OutputSettings& output = scene.output;
  Entries table(all, "output");
  const bool given = output.every_step || output.interval > 0;
  table.add_words("interval",
                  output.every_step ? "\"step\"" : toml_text(given ? output.interval : scene.time.end / 200), !given,
                  "T");
  list_keys(table, output);
}

std::string curve_text(const YieldCurve& curve, bool with_rate) {
  return fmt::format("{{ {}plastic_strain = {}, stress = {} }}",
                     with_rate ? fmt::format("rate = {}, ", toml_text(curve.rate)) : "",
                     toml_text(curve.plastic_strain), toml_text(curve.stress));
}

void list_materials(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const Material& material : scene.materials) {
    Entries table(all, "material." + material.name);
    list_keys(table, material);
    if (!material.plastic) continue;
    const std::vector<YieldCurve>& curves = material.yield_curves;
    table.add_words("yield_curve", curves.size() == 1 ? curve_text(curves[0], false) : "none", curves.size() != 1);
    std::string texts;
    for (const YieldCurve& curve : curves) texts += (texts.empty() ? "" : ", ") + curve_text(curve, true);
    table.add_words("yield_curves", curves.size() > 1 ? fmt::format("[{}]", texts) : "none", curves.size() < 2);
  }
}

}  // namespace

void list_element(const ElementSettings& element, const std::string& name, std::vector<SceneEntry>& all) {
  Entries table(all, name);
  list_keys(table, element, without_keys(element));
}

std::string toml_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::vector<SceneEntry> list_scene(const Scene& scene) {
  std::vector<SceneEntry> all;
  list_top(scene, all);
  list_table("time", scene.time, all);
  list_element(scene.element, "element", all);
  list_contact(scene, all);
  list_contact_parts(scene, all);
  list_table("skip", scene.skip, all);
  list_table("guard", scene.guard, all);
  list_table("damping", scene.damping, all);
  list_output(scene, all);
  list_materials(scene, all);
  list_bodies(scene, all);
  list_boundary(scene, all);
  return all;
}

}  // namespace pinball
