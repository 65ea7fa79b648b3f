#pragma once

#include <string>
#include <vector>

#include <solver/results.hpp>

namespace pinball {

/// A share of energy that a sound run keeps below a bound.
struct EnergyCheck {
  const char* what;     ///< a share of what it is, for a table
  double share;         ///< the largest of the run [-]
  double bound;         ///< up to where it is sound [-]
  std::string warning;  ///< where it is more: how much, since when, where, and what to try; empty: it is sound

  bool sound() const { return warning.empty(); }
};

/// Those that apply to the run: of contact where it has contact, of swallowed energy where nothing may swallow it.
std::vector<EnergyCheck> energy_checks(const RunSummary& summary);

}  // namespace pinball
