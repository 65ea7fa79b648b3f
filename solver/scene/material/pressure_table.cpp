#include "pressure_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <kernels/material/equation_of_state.hpp>

namespace pinball {

namespace {

constexpr std::size_t most_points = most_table_pieces + 1;

std::optional<Problem> problem_of_strains(const std::vector<double>& strain) {
  if (strain.size() < 2 || strain.size() > most_points) {
    return Problem{"volume_strain", fmt::format("expected 2 to {} numbers, got {}", most_points, strain.size())};
  }
  const double sign = strain.front() < strain.back() ? 1 : -1;
  for (std::size_t k = 1; k < strain.size(); ++k) {
    if (std::isfinite(strain[k]) && std::isfinite(strain[k - 1]) && sign * (strain[k] - strain[k - 1]) > 0) continue;
    return Problem{"volume_strain", fmt::format("expected numbers that all rise or all fall, got {:.6g} after {:.6g}",
                                                strain[k], strain[k - 1])};
  }
  return {};
}

/// A column beside that of the strains.
std::optional<Problem> problem_of_column(const char* key, const std::vector<double>& column, std::size_t points) {
  if (column.size() != points) {
    return Problem{key,
                   fmt::format("expected as many numbers as volume_strain has, {}, got {}", points, column.size())};
  }
  for (const double one : column) {
    if (!std::isfinite(one)) return Problem{key, fmt::format("expected finite numbers, got {}", one)};
  }
  return {};
}

/// Of what crushes.
std::optional<Problem> problem_of_crushing(const EquationOfStateSettings& eos) {
  const std::size_t given = eos.unloading_modulus.size(), points = eos.volume_strain.size();
  if (given == 0) return {};
  if (given != 1 && given != points) {
    return Problem{"unloading_modulus",
                   fmt::format("expected one number, or as many as volume_strain has, {}, got {}", points, given)};
  }
  if (const double first = *std::ranges::max_element(eos.volume_strain); first != 0) {
    return Problem{"volume_strain",
                   fmt::format("expected a curve that begins at 0 beside unloading_modulus, which is also that of "
                               "tension, got {:.6g}",
                               first)};
  }
  return {};
}

/// The pieces that have the state at rest: one, or two that meet there.
std::vector<TablePiece> pieces_at_rest(const EquationOfStateSettings& eos) {
  const std::vector<TablePiece> pieces = pieces_of_table(eos);
  const auto after = std::find_if(pieces.begin() + 1, pieces.end(), [](const TablePiece& p) { return p.strain > 0; });
  const auto at = std::prev(after);
  std::vector<TablePiece> found{*at};
  if (at->strain == 0 && at != pieces.begin()) found.push_back(*std::prev(at));
  return found;
}

}  // namespace

std::vector<TablePiece> pieces_of_table(const EquationOfStateSettings& eos) {
  struct TablePoint {
    double strain, cold, thermal, unloading;
  };
  std::vector<TablePoint> points;
  for (std::size_t k = 0; k < eos.volume_strain.size(); ++k) {
    const double thermal = eos.energy_factor.empty() ? 0.0 : eos.energy_factor[k];
    const std::vector<double>& given = eos.unloading_modulus;
    const double unloading = given.empty() ? 0.0 : given.size() == 1 ? given.front() : given[k];
    points.push_back({0.0 - eos.volume_strain[k], eos.pressure[k], thermal, unloading});
  }
  std::ranges::sort(points, {}, &TablePoint::strain);
  std::vector<TablePiece> pieces;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const TablePoint &from = points[k], &to = points[k + 1];
    const double length = to.strain - from.strain;
    const auto rise = [length](double begin, double end) { return (end - begin) / length; };
    pieces.push_back({from.strain, from.cold, rise(from.cold, to.cold), from.thermal, rise(from.thermal, to.thermal),
                      from.unloading, rise(from.unloading, to.unloading)});
  }
  return pieces;
}

std::optional<Problem> problem_of_table(const EquationOfStateSettings& eos) {
  constexpr double round_off = 1e-9;  // of the largest pressure
  const std::size_t points = eos.volume_strain.size();
  if (const auto problem = problem_of_strains(eos.volume_strain)) return problem;
  if (const auto problem = problem_of_column("pressure", eos.pressure, points)) return problem;
  if (!eos.energy_factor.empty()) {
    if (const auto problem = problem_of_column("energy_factor", eos.energy_factor, points)) return problem;
  }
  if (const auto problem = problem_of_crushing(eos)) return problem;
  const std::vector<TablePiece> at_rest = pieces_at_rest(eos);
  const TablePiece& piece = at_rest.front();
  const double pressure = piece.cold - piece.cold_rise * piece.strain;
  double largest = 0;
  for (const double one : eos.pressure) largest = std::max(largest, std::abs(one));
  if (std::abs(pressure) > round_off * largest) {
    return Problem{"pressure", fmt::format("expected 0 at a volume_strain of 0, where a body presses on nothing, "
                                           "got {:.6g}",
                                           pressure)};
  }
  for (const TablePiece& one : at_rest) {
    if (one.cold_rise > 0) continue;
    return Problem{"pressure", fmt::format("expected a bulk modulus at rest > 0, got {:.6g}", one.cold_rise)};
  }
  return {};
}

double bulk_modulus_of_table(const EquationOfStateSettings& eos) {
  if (problem_of_table(eos)) return 0;
  double largest = 0;
  for (const TablePiece& piece : pieces_at_rest(eos)) {
    largest = std::max({largest, piece.cold_rise, piece.unloading});
  }
  return largest;
}

}  // namespace pinball
