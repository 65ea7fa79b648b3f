#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <pinball/solver/error.hpp>
#include <pinball/solver/history.hpp>
#include <pinball/solver/output_file.hpp>
#include <pinball/solver/units.hpp>
#include <string_view>

namespace pinball {
namespace {

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
  // The sign of a NaN says nothing and not every reader takes "-nan".
  line += std::isnan(value) ? std::string(",nan") : fmt::format(",{:.17g}", value);
}

}  // namespace

HistoryWriter::HistoryWriter(const std::string& folder, const std::vector<std::string>& bodies,
                             const std::string& units, const std::vector<std::string>& more)
    : path_((std::filesystem::path(folder) / "history.csv").string()), bodies_(bodies.size()), more_(more.size()) {
  make_folder(folder);
  std::string head = fmt::format("# {}\n", units_line(units));
  head +=
      "step,time,dt,kinetic,internal,hourglass,bulk_viscosity,contact_stored,contact_damped,eroded,external,total,"
      "balance_error,momentum_x,momentum_y,momentum_z";
  for (const std::string& body : bodies) {
    for (const std::string_view quantity :
         {"velocity_x", "velocity_y", "velocity_z", "mass_remaining", "eroded_elements", "max_plastic_strain"}) {
      head += ',' + cell(fmt::format("{}_{}", body, quantity));
    }
  }
  for (const std::string& column : more) head += ',' + cell(column);
  file_ = std::fopen(path_.c_str(), "wb");
  if (file_ == nullptr) throw_write_error(path_, errno);
  try {
    append(head + '\n');
  } catch (...) {
    std::fclose(file_);
    throw;
  }
}

HistoryWriter::~HistoryWriter() { std::fclose(file_); }

void HistoryWriter::write(const HistoryRow& row) {
  if (row.bodies.size() != bodies_ || row.more.size() != more_) {
    throw RunError(fmt::format("cannot write {}: the row has {} bodies and {} further values, the columns {} and {}",
                               path_, row.bodies.size(), row.more.size(), bodies_, more_));
  }
  std::string line = fmt::format("{}", row.step);
  const Energies& e = row.energy;
  for (const double value :
       {row.time, row.dt, e.kinetic, e.internal, e.hourglass, e.bulk_viscosity, e.contact_stored, e.contact_damped,
        e.eroded, e.external, e.total(), row.balance_error, row.momentum[0], row.momentum[1], row.momentum[2]}) {
    add_number(line, value);
  }
  for (const BodyResult& body : row.bodies) {
    for (const double velocity : body.velocity) add_number(line, velocity);
    add_number(line, body.mass_remaining);
    line += fmt::format(",{}", body.eroded_elements);
    add_number(line, body.max_plastic_strain);
  }
  for (const double value : row.more) add_number(line, value);
  append(line + '\n');
}

void HistoryWriter::append(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size() || std::fflush(file_) != 0) {
    throw_write_error(path_, errno);
  }
}

}  // namespace pinball
