#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <solver/results.hpp>

namespace pinball {

/// Names of the columns, as HistoryWriter describes them.
std::vector<std::string> history_column_names(const std::vector<std::string>& bodies,
                                              const std::vector<std::string>& more);
/// The numbers of a row, one per column.
std::vector<double> history_numbers(const HistoryRow& row);

/// Writes FOLDER/history.csv: a comment line with the units, a line of column names, then one line per row.
///
/// Columns: step, time, dt, the parts of Energies and their total, balance_error (relative), momentum_x,y,z, and for
/// each body NAME_velocity_x,y,z, NAME_mass_remaining, NAME_eroded_elements, NAME_max_plastic_strain; then what walls
/// and probes add: NAME_force, NAME_impulse of a wall, NAME_QUANTITY of a probe, and with contact
/// NAME_contact_force_x,y,z of each body, the sum over its nodes; then NAME_force_x,y,z of constraints, prescribed
/// velocities and accelerations with a name, and with output.body_energies NAME_kinetic, NAME_momentum_x,y,z,
/// NAME_mass, NAME_internal, NAME_hourglass, NAME_bulk_viscosity of each body. Numbers have 17 digits, so that they
/// read back as the same doubles. Each row reaches the file before write() returns: a killed run keeps its history.
class HistoryWriter {
 public:
  /// `bodies`: names, in the order of HistoryRow::bodies. `units`: the scene's string. `more`: names of the columns
  /// that HistoryRow::more holds.
  /// `kept`: goes on with the file of an earlier run, of which it keeps so many bytes; without it the file is new.
  /// Throws RunError that names the file where it cannot be written, InputError where the file to go on with is too
  /// short or has other columns.
  HistoryWriter(const std::string& folder, const std::vector<std::string>& bodies, const std::string& units = {},
                const std::vector<std::string>& more = {}, const std::optional<std::uint64_t>& kept = {});
  ~HistoryWriter();
  HistoryWriter(const HistoryWriter&) = delete;
  HistoryWriter& operator=(const HistoryWriter&) = delete;

  /// Appends a row; it has the bodies that were named. Throws RunError that names the file.
  void write(const HistoryRow& row);
  std::uint64_t bytes() const { return written_; }  ///< of the file

 private:
  void cut(const std::string& head, std::uint64_t kept);
  void append(const std::string& text);

  std::string path_;
  std::size_t bodies_ = 0, more_ = 0;
  std::uint64_t written_ = 0;
  std::FILE* file_ = nullptr;
};

}  // namespace pinball
