#pragma once

#include <cstdio>
#include <pinball/solver/results.hpp>
#include <string>
#include <vector>

namespace pinball {

/// Writes FOLDER/history.csv: a comment line with the units, a line of column names, then one line per row.
///
/// Columns: step, time, dt, the parts of Energies and their total, balance_error (relative), momentum_x,y,z, and for
/// each body NAME_velocity_x,y,z, NAME_mass_remaining, NAME_eroded_elements, NAME_max_plastic_strain; then what walls
/// and probes add: NAME_force, NAME_impulse of a wall, NAME_QUANTITY of a probe. Numbers have 17 digits, so that they
/// read back as the same doubles. Each row reaches the file before write() returns: a killed run keeps its history.
class HistoryWriter {
 public:
  /// `bodies`: names, in the order of HistoryRow::bodies. `units`: the scene's string. `more`: names of the columns
  /// that HistoryRow::more holds.
  /// Throws RunError that names the file where it cannot be written.
  HistoryWriter(const std::string& folder, const std::vector<std::string>& bodies, const std::string& units = {},
                const std::vector<std::string>& more = {});
  ~HistoryWriter();
  HistoryWriter(const HistoryWriter&) = delete;
  HistoryWriter& operator=(const HistoryWriter&) = delete;

  /// Appends a row; it has the bodies that were named. Throws RunError that names the file.
  void write(const HistoryRow& row);

 private:
  void append(const std::string& text);

  std::string path_;
  std::size_t bodies_ = 0, more_ = 0;
  std::FILE* file_ = nullptr;
};

}  // namespace pinball
