#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <solver/base/state_hash.hpp>
#include <solver/results.hpp>

namespace pinball {

/// Names of the columns, as HistoryWriter describes them. Throws InputError where two have one name.
std::vector<std::string> history_column_names(const std::vector<std::string>& bodies,
                                              const std::vector<std::string>& more);
/// Whether a column is one of Energies of the whole model, or their total.
bool is_energy_column(std::string_view name);
/// The numbers of a row, one per column.
std::vector<double> history_numbers(const HistoryRow& row);

/// So many bytes of a history, and their StateHash.
struct HistoryPart {
  std::uint64_t bytes = 0, hash = 0;
};

/// Writes FOLDER/history.csv: a line of column names, then one line per row, as readers of tables take it; the units
/// are in summary.json.
///
/// Columns: step, time, dt, the parts of Energies and their total, balance_error (relative), momentum_x,y,z, and for
/// each body NAME_velocity_x,y,z, NAME_mass_remaining, NAME_eroded_elements, NAME_max_plastic_strain; then what walls
/// and probes add: NAME_force, NAME_impulse of a wall, NAME_QUANTITY of a probe, and with contact
/// NAME_contact_force_x,y,z of each body, the sum over its nodes, of those that bodies share by its part of their mass;
/// then NAME_force_x,y,z of constraints, prescribed velocities and accelerations with a name, and with
/// output.body_energies NAME_kinetic, NAME_momentum_x,y,z, NAME_mass, NAME_internal, NAME_hourglass,
/// NAME_bulk_viscosity of each body. Numbers have 17 digits, so that they read back as the same doubles. Each row
/// reaches the file before write() returns: a killed run keeps its history.
class HistoryWriter {
 public:
  /// `bodies`: names, in the order of HistoryRow::bodies. `more`: names of the columns that HistoryRow::more holds.
  /// `kept`: goes on with the file of an earlier run, of which it keeps this part; without it the file is new.
  /// Throws RunError that names the file where it cannot be written, InputError where the file to go on with does not
  /// begin with what is to be kept.
  HistoryWriter(const std::string& folder, const std::vector<std::string>& bodies,
                const std::vector<std::string>& more = {}, const std::optional<HistoryPart>& kept = {});
  ~HistoryWriter();
  HistoryWriter(const HistoryWriter&) = delete;
  HistoryWriter& operator=(const HistoryWriter&) = delete;

  /// Appends a row; it has the bodies that were named. Throws RunError that names the file.
  void write(const HistoryRow& row);
  HistoryPart written() const { return {written_, hash_.value()}; }  ///< all of the file

 private:
  void cut(const std::string& head, const HistoryPart& kept);
  void append(const std::string& text);

  std::string path_;
  std::size_t bodies_ = 0, more_ = 0;
  std::uint64_t written_ = 0;
  StateHash hash_;
  std::FILE* file_ = nullptr;
};

}  // namespace pinball
