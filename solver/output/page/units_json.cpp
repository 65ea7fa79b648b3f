#include "units_json.hpp"

#include <map>

namespace pinball {

nlohmann::ordered_json units_json(const Units& units) {
  return {{"time", units.time},   {"length", units.length},     {"velocity", units.velocity}, {"mass", units.mass},
          {"force", units.force}, {"momentum", units.momentum}, {"energy", units.energy},     {"stress", units.stress}};
}

std::string unit_of(const std::string& dimension, const Units& units) {
  const std::map<std::string, std::string> names{{"T", units.time},
                                                 {"L", units.length},
                                                 {"L/T", units.velocity},
                                                 {"M/(L T^2)", units.stress},
                                                 {"M L/T^2", units.force},
                                                 {"M/L^3", units.density},
                                                 {"1/T", units.time.empty() ? "" : "1/" + units.time},
                                                 {"-", ""}};
  const auto found = names.find(dimension);
  return found == names.end() ? dimension : found->second;
}

}  // namespace pinball
