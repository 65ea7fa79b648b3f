#include "history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string_view>

#include <solver/base/error.hpp>

#include "output_file.hpp"
#include "run_files.hpp"

namespace pinball {
namespace {

/// A column of the whole model.
struct ModelColumn {
  const char* name;
  bool is_energy = false;
};

constexpr std::array<ModelColumn, 20> model_columns{{{"step"},
                                                     {"time"},
                                                     {"dt"},
                                                     {"kinetic", true},
                                                     {"internal", true},
                                                     {"hourglass", true},
                                                     {"bulk_viscosity", true},
                                                     {"contact_stored", true},
                                                     {"contact_damped", true},
                                                     {"eroded", true},
                                                     {"external", true},
                                                     {"total", true},
                                                     {"balance_error"},
                                                     {"momentum_x"},
                                                     {"momentum_y"},
                                                     {"momentum_z"},
                                                     {"hourglass_plastic", true},
                                                     {"folding", true},
                                                     {"inside_out_elements"},
                                                     {"kinetic_below_zero", true}}};

/// A name as a CSV cell: quoted where it holds a separator.
std::string cell(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

void add_number(std::string& line, double value) {
  if (!line.empty()) line += ',';
  // The sign of a NaN says nothing and not every reader takes "-nan".
  line += std::isnan(value) ? std::string("nan") : fmt::format("{:.17g}", value);
}

}  // namespace

std::vector<std::string> history_column_names(const std::vector<std::string>& bodies,
                                              const std::vector<std::string>& more) {
  std::vector<std::string> names;
  for (const ModelColumn& column : model_columns) names.emplace_back(column.name);
  for (const std::string& body : bodies) {
    for (const char* quantity :
         {"velocity_x", "velocity_y", "velocity_z", "mass_remaining", "eroded_elements", "max_plastic_strain"}) {
      names.push_back(fmt::format("{}_{}", body, quantity));
    }
  }
  names.insert(names.end(), more.begin(), more.end());
  std::set<std::string_view> known;
  for (const std::string& name : names) {
    if (known.insert(name).second) continue;
    throw InputError(
        fmt::format("two columns of history.csv would have the name {}: expected names of bodies, rigid bodies, walls, "
                    "probes, pairs and forces that keep theirs apart",
                    name));
  }
  return names;
}

bool is_energy_column(std::string_view name) {
  return std::any_of(model_columns.begin(), model_columns.end(),
                     [name](const ModelColumn& column) { return column.is_energy && column.name == name; });
}

std::vector<double> history_numbers(const HistoryRow& row) {
  const Energies& e = row.energy;
  std::vector<double> numbers{static_cast<double>(row.step),
                              row.time,
                              row.dt,
                              e.kinetic,
                              e.internal,
                              e.hourglass,
                              e.bulk_viscosity,
                              e.contact_stored,
                              e.contact_damped,
                              e.eroded,
                              e.external,
                              e.total(),
                              row.balance_error,
                              row.momentum[0],
                              row.momentum[1],
                              row.momentum[2],
                              e.hourglass_plastic,
                              e.folding,
                              static_cast<double>(row.inside_out),
                              e.kinetic_below_zero};
  for (const BodyResult& body : row.bodies) {
    numbers.insert(numbers.end(), body.velocity.begin(), body.velocity.end());
    numbers.insert(numbers.end(),
                   {body.mass_remaining, static_cast<double>(body.eroded_elements), body.max_plastic_strain});
  }
  numbers.insert(numbers.end(), row.more.begin(), row.more.end());
  return numbers;
}

HistoryWriter::HistoryWriter(const std::string& folder, const std::vector<std::string>& bodies,
                             const std::vector<std::string>& more, const std::optional<HistoryPart>& kept)
    : path_(in_folder(folder, history_name)), bodies_(bodies.size()), more_(more.size()) {
  make_folder(folder);
  std::string head;
  for (const std::string& column : history_column_names(bodies, more)) {
    if (!head.empty()) head += ',';
    head += cell(column);
  }
  head += '\n';
  if (kept) cut(head, *kept);
  file_ = std::fopen(path_.c_str(), kept ? "ab" : "wb");
  if (file_ == nullptr) throw_write_error(path_, errno);
  if (kept) return;
  try {
    append(head);
  } catch (...) {
    std::fclose(file_);
    throw;
  }
}

/// Cuts off what an earlier run has written after the state that this one goes on from.
void HistoryWriter::cut(const std::string& head, const HistoryPart& kept) {
  std::ifstream file(path_, std::ios::binary);
  std::string piece(std::max<std::size_t>(head.size(), 1U << 16), '\0');
  bool begins = true;
  for (std::uint64_t left = kept.bytes; left > 0 && file;) {
    file.read(piece.data(), std::min<std::uint64_t>(left, piece.size()));
    const std::size_t count = file.gcount();
    if (left == kept.bytes) begins = std::string_view(piece).substr(0, count).starts_with(head);
    hash_.add(piece.data(), count);
    left -= count;
  }
  if (!file || !begins || hash_.value() != kept.hash) {
    throw InputError(
        fmt::format("{}: expected the rows up to the time of the checkpoint, as the run has written "
                    "them; with --out the results go to another folder",
                    path_));
  }
  std::error_code error;
  std::filesystem::resize_file(path_, kept.bytes, error);
  if (error) throw_write_error(path_, error.value());
  written_ = kept.bytes;
}

HistoryWriter::~HistoryWriter() { std::fclose(file_); }

void HistoryWriter::write(const HistoryRow& row) {
  if (row.bodies.size() != bodies_ || row.more.size() != more_) {
    throw RunError(fmt::format("cannot write {}: the row has {} bodies and {} further values, the columns {} and {}",
                               path_, row.bodies.size(), row.more.size(), bodies_, more_));
  }
  std::string line;
  for (const double value : history_numbers(row)) add_number(line, value);
  append(line + '\n');
}

void HistoryWriter::append(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0) {
    throw_write_error(path_, errno);
  }
  written_ += text.size();
  hash_.add(text.data(), text.size());
}

}  // namespace pinball
