#include "netcdf_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include <solver/base/error.hpp>
#include <solver/mesh/file/input_file.hpp>

#include "netcdf_header.hpp"

#ifdef PINBALL_NETCDF
#include <netcdf.h>
#endif

namespace pinball {

void NetcdfFile::fail(const std::string& variable, const std::string& problem) const {
  throw InputError(fmt::format("{}: variable {}: {}", path_, variable, problem));
}

#ifdef PINBALL_NETCDF

namespace {

std::recursive_mutex& netcdf_turn() {
  static std::recursive_mutex turn;
  return turn;
}

}  // namespace

NetcdfFile::NetcdfFile(const std::string& path) : turn_(netcdf_turn()), path_(path) {
  require_file(path);
  check_netcdf_header(path);
  // Deflated data takes at least a 1032nd of its size.
  most_ = 1032 * static_cast<std::int64_t>(std::filesystem::file_size(path));
  const int status = nc_open(path.c_str(), NC_NOWRITE, &file_);
  if (status != NC_NOERR) throw InputError(fmt::format("{}: not a netCDF file: {}", path, nc_strerror(status)));
}

NetcdfFile::~NetcdfFile() { nc_close(file_); }

void NetcdfFile::require(int status, const std::string& variable) const {
  if (status != NC_NOERR) fail(variable, nc_strerror(status));
}

std::int64_t NetcdfFile::dimension(const std::string& name) const {
  int number = 0;
  std::size_t length = 0;
  if (nc_inq_dimid(file_, name.c_str(), &number) != NC_NOERR) return 0;
  if (nc_inq_dimlen(file_, number, &length) != NC_NOERR) return 0;
  return length;
}

bool NetcdfFile::has(const std::string& variable) const {
  int number = 0;
  return nc_inq_varid(file_, variable.c_str(), &number) == NC_NOERR;
}

int NetcdfFile::number_of(const std::string& variable) const {
  int number = 0;
  if (nc_inq_varid(file_, variable.c_str(), &number) != NC_NOERR) fail(variable, "is not there");
  return number;
}

std::vector<std::int64_t> NetcdfFile::shape(const std::string& variable) const {
  const int number = number_of(variable);
  int rank = 0, dimensions[NC_MAX_VAR_DIMS];
  require(nc_inq_varndims(file_, number, &rank), variable);
  require(nc_inq_vardimid(file_, number, dimensions), variable);
  std::vector<std::int64_t> lengths;
  double all = 1;
  for (int d = 0; d < rank; ++d) {
    std::size_t length = 0;
    require(nc_inq_dimlen(file_, dimensions[d], &length), variable);
    lengths.push_back(length);
    all *= length;
  }
  if (all > most_) fail(variable, "is longer than the file can hold");
  return lengths;
}

std::int64_t NetcdfFile::length(const std::string& variable) const {
  std::int64_t all = 1;
  for (const std::int64_t length : shape(variable)) all *= length;
  return all;
}

std::vector<double> NetcdfFile::numbers(const std::string& variable) const {
  std::vector<double> values(length(variable));
  require(nc_get_var_double(file_, number_of(variable), values.data()), variable);
  return values;
}

std::vector<std::int64_t> NetcdfFile::integers(const std::string& variable) const {
  std::vector<long long> values(length(variable));
  require(nc_get_var_longlong(file_, number_of(variable), values.data()), variable);
  return {values.begin(), values.end()};
}

void NetcdfFile::integers_into(const std::string& variable, std::int32_t* to) const {
  require(nc_get_var_int(file_, number_of(variable), to), variable);
}

std::vector<std::string> NetcdfFile::texts(const std::string& variable) const {
  const std::vector<std::int64_t> lengths = shape(variable);
  if (lengths.size() != 2) fail(variable, "expected rows of characters");
  std::vector<char> all(length(variable));
  require(nc_get_var_text(file_, number_of(variable), all.data()), variable);
  std::vector<std::string> rows;
  for (std::int64_t row = 0; row < lengths[0]; ++row) {
    const std::string text(all.data() + row * lengths[1], lengths[1]);
    rows.push_back(text.substr(0, text.find('\0')));
    rows.back().erase(rows.back().find_last_not_of(' ') + 1);
  }
  return rows;
}

std::string NetcdfFile::attribute(const std::string& variable, const std::string& name) const {
  std::size_t length = 0;
  nc_type type = NC_NAT;
  const int number = number_of(variable);
  if (nc_inq_att(file_, number, name.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR) return "";
  std::string text(length, '\0');
  require(nc_get_att_text(file_, number, name.c_str(), text.data()), variable);
  return text.substr(0, text.find('\0'));
}

#else  // built without libnetcdf: nothing but the message is left

NetcdfFile::NetcdfFile(const std::string& path) : path_(path) {
  throw InputError(path +
                   ": this program was built without netCDF, which Exodus meshes need: install libnetcdf-dev "
                   "(apt-get install libnetcdf-dev, or libnetcdf of another system) and build it again");
}
NetcdfFile::~NetcdfFile() = default;
std::int64_t NetcdfFile::dimension(const std::string&) const { return 0; }
bool NetcdfFile::has(const std::string&) const { return false; }
std::vector<std::int64_t> NetcdfFile::shape(const std::string&) const { return {}; }
std::vector<double> NetcdfFile::numbers(const std::string&) const { return {}; }
std::vector<std::int64_t> NetcdfFile::integers(const std::string&) const { return {}; }
void NetcdfFile::integers_into(const std::string&, std::int32_t*) const {}
std::vector<std::string> NetcdfFile::texts(const std::string&) const { return {}; }
std::string NetcdfFile::attribute(const std::string&, const std::string&) const { return ""; }

#endif

}  // namespace pinball
