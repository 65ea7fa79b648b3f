#include "listing.hpp"

#include <solver/scene_rules.hpp>

#include "entries.hpp"

namespace pinball {

namespace {

void list_top(const Scene& scene, std::vector<SceneEntry>& all) {
  Entries top(all, "");
  top.add("title", scene.title, std::string(), "");
  top.add("units", scene.units, std::string(), "");
  const bool is_double = scene.precision == Precision::float64;
  top.add_words("precision", toml_text(is_double ? "double" : "float"), is_double);
  top.add("--refine", scene.refine, 1, "");
}

void list_time(const Scene& scene, std::vector<SceneEntry>& all) {
  const TimeSettings& time = scene.time;
  Entries table(all, "time");
  table.add_numbers(time, {});
  table.add_words("steps", time.steps < 0 ? "-1 (no limit)" : toml_text(time.steps), time.steps < 0);
  table.add("subcycling", time.subcycling, false, "");
  const bool small = time.mass_scaling == MassScaling::small;
  table.add_words("mass_scaling", toml_text(small ? "small" : "all"), small);
}

const char* name_of(HourglassControl control) {
  return control == HourglassControl::none        ? "none"
         : control == HourglassControl::viscous   ? "viscous"
         : control == HourglassControl::stiffness ? "stiffness"
                                                  : "assumed_strain";
}

const char* name_of(InsideOut policy) {
  return policy == InsideOut::warn ? "warn" : policy == InsideOut::erode ? "erode" : "stop";
}

}  // namespace

void list_element(const ElementSettings& element, const std::string& name, std::vector<SceneEntry>& all) {
  Entries table(all, name);
  table.add_words("hourglass", toml_text(name_of(element.hourglass)), element.hourglass == ElementSettings{}.hourglass);
  table.add("bulk_viscosity", element.bulk_viscosity, true, "");
  ElementSettings without;
  without.hourglass = element.hourglass;
  complete(without);
  table.add_numbers(element, without);
  table.add_words("negative_volume",
                  !element.negative_volume
                      ? "\"erode\" where a material erodes, else \"stop\""
                      : toml_text(*element.negative_volume == NegativeVolume::stop ? "stop" : "erode"),
                  !element.negative_volume);
  table.add_words("inside_out", toml_text(name_of(element.inside_out)), element.inside_out == InsideOut::warn);
}

namespace {

const char* name_of(ContactMethod method) {
  return method == ContactMethod::none ? "none" : method == ContactMethod::pinball ? "pinball" : "slideline";
}

void list_contact(const Scene& scene, std::vector<SceneEntry>& all) {
  const ContactSettings& contact = scene.contact;
  ContactSettings without;
  without.enforcement = contact.enforcement;
  without.friction = contact.friction;  // at rest it is the same, if not given
  complete(without);
  without.friction = 0;
  Entries table(all, "contact");
  const bool not_set = contact.method == ContactMethod::not_set;
  table.add_words("method", not_set ? "pinball where bodies can meet" : toml_text(name_of(contact.method)), not_set);
  table.add_words("enforcement", toml_text(enforcement_name(contact.enforcement)),
                  contact.enforcement == ContactSettings{}.enforcement);
  table.add_words("gap", toml_text(contact.gap == ContactGap::pinball ? "pinball" : "face"),
                  contact.gap == without.gap);
  table.add_numbers(contact, without);
  table.add_words("radius", toml_text(contact.radius == ContactRadius::initial ? "initial" : "current"),
                  contact.radius == without.radius);
  table.add("self", contact.self, without.self, "");
  table.add_words("search",
                  contact.search == ContactSearch::automatic
                      ? "what suits the scene"
                      : toml_text(contact.search == ContactSearch::tree ? "tree" : "hash"),
                  contact.search == ContactSearch::automatic);
  table.add_words("overlap", toml_text(contact.overlap == ContactOverlap::keep ? "keep" : "adjust"),
                  contact.overlap == without.overlap);
}

void list_guards_and_skips(const Scene& scene, std::vector<SceneEntry>& all) {
  Entries skip(all, "skip");
  skip.add("contact_search", scene.skip.contact_search, true, "");
  skip.add("resting", scene.skip.resting, true, "");
  Entries(all, "guard").add_numbers(scene.guard, {});
  Entries(all, "damping").add_numbers(scene.damping, {});
}

void list_output(const Scene& scene, std::vector<SceneEntry>& all) {
  const OutputSettings& output = scene.output;
  Entries table(all, "output");
  const bool given = output.every_step || output.interval > 0;
  table.add_words("interval",
                  output.every_step ? "\"step\"" : toml_text(given ? output.interval : scene.time.end / 200), !given,
                  "T");
  table.add("field_interval", output.field_interval, 0.0, "T");
  table.add("field_times", output.field_times, {}, "T");
  table.add("fields", output.fields, OutputSettings{}.fields, "");
  table.add("body_energies", output.body_energies, false, "");
}

std::string curve_text(const YieldCurve& curve, bool with_rate) {
  return fmt::format("{{ {}plastic_strain = {}, stress = {} }}",
                     with_rate ? fmt::format("rate = {}, ", toml_text(curve.rate)) : "",
                     toml_text(curve.plastic_strain), toml_text(curve.stress));
}

void list_curves(Entries& table, const Material& material) {
  const std::vector<YieldCurve>& curves = material.yield_curves;
  table.add_words("yield_curve", curves.size() == 1 ? curve_text(curves[0], false) : "none", curves.size() != 1);
  std::string texts;
  for (const YieldCurve& curve : curves) texts += (texts.empty() ? "" : ", ") + curve_text(curve, true);
  table.add_words("yield_curves", curves.size() > 1 ? fmt::format("[{}]", texts) : "none", curves.size() < 2);
  const bool linear = material.rate_interpolation == RateInterpolation::linear;
  table.add_words("rate_interpolation", toml_text(linear ? "linear" : "logarithmic"), linear);
  const StrainRate rate = material.strain_rate;
  const char* const name = rate == StrainRate::total ? "total" : rate == StrainRate::plastic ? "plastic" : "deviatoric";
  table.add_words("strain_rate", toml_text(name), rate == StrainRate::total);
}

void list_materials(const Scene& scene, std::vector<SceneEntry>& all) {
  for (const Material& material : scene.materials) {
    Entries table(all, "material." + material.name);
    const std::string stress = "M/(L T^2)";
    table.add("model", material.plastic ? "von_mises" : "elastic");
    table.add("bulk_modulus", material.bulk_modulus, stress);
    table.add("shear_modulus", material.shear_modulus, stress);
    table.add_numbers(material, {});
    if (!material.plastic) continue;
    table.add("yield_stress", material.yield_stress, stress);
    const bool bounded = material.ultimate_stress > 0 && std::isfinite(material.ultimate_stress);
    table.add_words("ultimate_stress", bounded ? toml_text(material.ultimate_stress) : "infinite", !bounded, stress);
    list_curves(table, material);
  }
}

}  // namespace

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

std::string Entries::unit_of(std::string_view key) const {
  static const std::vector<std::pair<std::string_view, std::string_view>> units{{"end", "T"},
                                                                                {"smallest_step", "T"},
                                                                                {"interval", "T"},
                                                                                {"field_interval", "T"},
                                                                                {"density", "M/L^3"},
                                                                                {"position", "L"},
                                                                                {"point", "L"},
                                                                                {"centre", "L"},
                                                                                {"tolerance", "L"},
                                                                                {"start", "T"},
                                                                                {"pressure", "M/(L T^2)"},
                                                                                {"velocity", "L/T"},
                                                                                {"velocity_noise", "L/T"},
                                                                                {"angular_velocity", "1/T"},
                                                                                {"force", "M L/T^2"},
                                                                                {"plastic_modulus", "M/(L T^2)"},
                                                                                {"mass", "1/T"},
                                                                                {"acceleration", "L/T^2"},
                                                                                {"start", "T"},
                                                                                {"friction_decay", "T/L"},
                                                                                {"rate_constant", "1/T"},
                                                                                {"rate_stress", "M/(L T^2)"}};
  for (const auto& [name, unit] : units) {
    if (name == key) return std::string(unit);
  }
  return "-";
}

std::vector<SceneEntry> list_scene(const Scene& scene) {
  std::vector<SceneEntry> all;
  list_top(scene, all);
  list_time(scene, all);
  list_element(scene.element, "element", all);
  list_contact(scene, all);
  list_contact_parts(scene, all);
  list_guards_and_skips(scene, all);
  list_output(scene, all);
  list_materials(scene, all);
  list_bodies(scene, all);
  list_boundary(scene, all);
  return all;
}

}  // namespace pinball
