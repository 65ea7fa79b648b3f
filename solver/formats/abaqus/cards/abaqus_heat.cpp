#include "abaqus_heat.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pinball {

namespace {

constexpr double most_flow =
    0.01;  ///< what an element gives each neighbour of the difference of their temperatures [-]

bool gives_temperatures(const AbaqusBlock& block) {
  return block.name == "INITIALCONDITIONS" && block.option("TYPE") == "TEMPERATURE";
}

/// The one number of an option.
double only_number(const AbaqusBlock& block, const char* what) {
  DataLines lines(block);
  const DataLine card = lines.require(what);
  return DataFields(card).number(0, what);
}

/// Per node of the mesh, later lines in the place of earlier ones; where the last one stands.
std::vector<double> temperatures_of_nodes(const AbaqusData& data, DeckPlace& last) {
  std::vector<double> temperatures(data.used.size(), 0.0);
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (!gives_temperatures(block)) continue;
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      const double value = f.number(1, "temperature");
      for (const std::int32_t node : data.nodes(f.text(0), card->place).members) temperatures[node] = value;
      last = card->place;
    }
  }
  return temperatures;
}

/// Per part of the mesh: whether it is a body of the material.
std::vector<bool> parts_of_material(const AbaqusData& data, const std::string& material) {
  std::vector<bool> parts(data.mesh.file.parts.size(), false);
  for (const AbaqusBody& body : data.bodies) parts[body.section] = parts[body.section] || body.material == material;
  return parts;
}

/// *DYNAMIC TEMPERATURE-DISPLACEMENT
bool lets_heat_flow(const AbaqusBlock& block) {
  return block.name == "DYNAMIC" && block.title.find('-') != std::string::npos;
}

/// The step keeps, or conducts, the heat of plastic work.
bool warms_materials(const AbaqusBlock& block) {
  return lets_heat_flow(block) || (block.name == "DYNAMIC" && block.has("ADIABATIC"));
}

/// The first of these; null: there is none.
const AbaqusBlock* flow_of_heat(const AbaqusDeck& deck) {
  const auto found = std::ranges::find_if(deck.blocks, lets_heat_flow);
  return found == deck.blocks.end() ? nullptr : &*found;
}

/// The shortest edge of the elements of a material [length].
double shortest_edge(const AbaqusData& data, const std::string& material) {
  constexpr std::array<std::array<int, 2>, 12> ends{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  const std::vector<bool> has = parts_of_material(data, material);
  const Mesh& mesh = data.mesh.file.mesh;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    if (!has[data.mesh.file.part[e]]) continue;
    for (const auto& [from, to] : ends) {
      const std::int32_t a = mesh.hexahedra[e][from], b = mesh.hexahedra[e][to];
      if (a != b) shortest = std::min(shortest, norm(minus(mesh.nodes[a], mesh.nodes[b])));
    }
  }
  return shortest;
}

}  // namespace

bool is_adiabatic(const AbaqusDeck& deck) { return std::ranges::any_of(deck.blocks, warms_materials); }

void require_heat_in_all_steps(AbaqusData& data) {
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "DYNAMIC" || warms_materials(block)) continue;
    return data.report.reject(block.place, "*DYNAMIC: ADIABATIC in some of the steps alone",
                              "give it to all steps, or to none");
  }
}

double initial_temperature(AbaqusData& data, const std::string& material) {
  DeckPlace last;
  const std::vector<double> of_node = temperatures_of_nodes(data, last);
  const std::vector<bool> has = parts_of_material(data, material);
  std::optional<double> lowest, highest;
  for (std::size_t e = 0; e < data.mesh.file.part.size(); ++e) {
    if (!has[data.mesh.file.part[e]]) continue;
    for (const std::int32_t node : data.mesh.file.mesh.hexahedra[e]) {
      lowest = std::min(lowest.value_or(of_node[node]), of_node[node]);
      highest = std::max(highest.value_or(of_node[node]), of_node[node]);
    }
  }
  if (lowest != highest)
    data.report.reject(last, "*INITIAL CONDITIONS, TYPE=TEMPERATURE that differ within a material",
                       "give all nodes of the material the same");
  return lowest.value_or(0.0);
}

HeatConstants heat_constants(const AbaqusHeat& heat, const DeckPlace& material) {
  if (heat.specific_heat == nullptr)
    fail_at(material, "*MATERIAL: expected *SPECIFIC HEAT, for the step is ADIABATIC and plastic work warms it");
  HeatConstants constants{only_number(*heat.specific_heat, "specific heat")};
  if (!(constants.specific_heat > 0))
    fail_at(heat.specific_heat->place,
            fmt::format("*SPECIFIC HEAT: expected more than 0, got {}", constants.specific_heat));
  if (heat.share != nullptr) {
    constants.share = only_number(*heat.share, "inelastic heat fraction");
    if (!(constants.share >= 0 && constants.share <= 1))
      fail_at(heat.share->place, fmt::format("*INELASTIC HEAT FRACTION: expected 0 to 1, got {}", constants.share));
  }
  return constants;
}

void require_little_flow(AbaqusData& data, const std::string& material, const AbaqusHeat& heat,
                         const HeatConstants& constants, double density) {
  const AbaqusBlock* flow = flow_of_heat(data.deck);
  if (flow == nullptr) return;
  if (heat.share == nullptr)
    data.report.reject(flow->place, flow->star_name() + " without INELASTIC HEAT FRACTION", "give it: 0.9, or 0");
  if (heat.conductivity == nullptr) return;
  const double conductivity = only_number(*heat.conductivity, "conductivity"), edge = shortest_edge(data, material),
               share = conductivity * data.end() / (density * constants.specific_heat * edge * edge);
  const std::string text =
      fmt::format("elements give a neighbour up to {:.3g} % of the difference of their temperatures", 100 * share);
  if (share > most_flow) {
    data.report.reject(heat.conductivity->place, flow->star_name() + " with a CONDUCTIVITY that counts",
                       text + ": *DYNAMIC, EXPLICIT, ADIABATIC where heat may stay");
  } else {
    data.report.understood(
        fmt::format("{} ({}): heat stays where it is; {}", flow->star_name(), flow->place.text(), text));
  }
}

EquationOfStateSettings expanding_pressure(const AbaqusHeat& heat, const HeatConstants& constants, double bulk_modulus,
                                           double density) {
  const double expansion = only_number(*heat.expansion, "coefficient of expansion");
  const double per_energy =
      3 * bulk_modulus * expansion * constants.share / (density * constants.specific_heat);  // [-]
  EquationOfStateSettings pressure;
  pressure.form = EquationOfStateForm::polynomial;
  pressure.coefficients = {0, bulk_modulus, -bulk_modulus / 2, bulk_modulus / 3, per_energy, 0, 0};
  return pressure;
}

void tell_unused_heat(AbaqusData& data, const AbaqusHeat& heat, const std::string& reason) {
  for (const AbaqusBlock* block : {heat.specific_heat, heat.share, heat.expansion}) {
    if (block == nullptr) continue;
    data.report.unused(block->place, block->star_name(), reason);
    if (block->log != nullptr) block->log->done(block);
  }
}

void tell_unused_temperatures(AbaqusData& data) {
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (!gives_temperatures(block) || block.log == nullptr || block.log->lines_of(&block) > 0) continue;
    data.report.unused(block.place, "*INITIAL CONDITIONS, TYPE=TEMPERATURE", "nothing depends on it");
    block.log->done(&block);
  }
}

}  // namespace pinball
