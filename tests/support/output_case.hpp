#pragma once

#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include <solver/results.hpp>

/// Small cases for the tests of the output files.
namespace pinball::test {

/// A folder of its own in the temporary folder, removed at the end.
struct TemporaryFolder {
  std::filesystem::path path;

  explicit TemporaryFolder(const std::string& name)
      : path(std::filesystem::temp_directory_path() / ("pinball_" + name + "_" + std::to_string(getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
  std::string operator/(const std::string& name) const { return (path / name).string(); }
};

/// Appends a block of n[0] x n[1] x n[2] cubes of side h as one more body; every field of an element or node has a
/// value of its own, all of them exact in Float32.
inline void add_block(FieldSnapshot& s, const std::array<int, 3>& n, double h, const Point& corner, std::int32_t body) {
  const auto first = static_cast<std::int32_t>(s.position.size());
  const auto node = [&](int i, int j, int k) { return first + i + (n[0] + 1) * (j + (n[1] + 1) * k); };
  for (int k = 0; k <= n[2]; ++k) {
    for (int j = 0; j <= n[1]; ++j) {
      for (int i = 0; i <= n[0]; ++i) {
        const auto id = static_cast<double>(s.position.size());
        s.position.push_back({corner[0] + i * h, corner[1] + j * h, corner[2] + k * h});
        s.velocity.push_back({id, -2.0 * id, 0.5});
        s.contact_force.push_back({0.0, id, 0.25 * id});
      }
    }
  }
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const auto id = static_cast<double>(s.hexahedra.size());
        s.hexahedra.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                               node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                               node(i, j + 1, k + 1)});
        s.stress.push_back({100.0 + id, 2.0, 3.0, 4.0, 5.0, 6.0});
        s.plastic_strain.push_back(0.125 * id);
        s.pinball_radius.push_back(0.5 * h);
        s.alive.push_back(1);
        s.body.push_back(body);
      }
    }
  }
}

/// Two blocks, the second one moved by `shift`; the last element is eroded.
inline FieldSnapshot two_blocks(double time, double shift) {
  FieldSnapshot s;
  s.time = time;
  add_block(s, {4, 2, 1}, 0.25, {0.0, 0.0, 0.0}, 0);
  add_block(s, {1, 1, 3}, 0.25, {0.25 + shift, 0.0, 0.5 - shift}, 1);
  s.alive.back() = 0;
  return s;
}

inline HistoryRow history_row(std::int64_t step, double time) {
  HistoryRow row;
  row.step = step;
  row.time = time;
  row.dt = 1e-8;
  row.energy = {.kinetic = 90.0 - 1e6 * time,
                .internal = 1.0 + 8e5 * time,
                .hourglass = 2.0,
                .bulk_viscosity = 3.0,
                .contact_stored = 4.0,
                .contact_damped = 5.0,
                .eroded = 2e5 * time,
                .external = 7.0};
  row.balance_error = 1e-3 * time / 1e-5;
  row.momentum = {1.0, 2.0, -3.0};
  for (const char* name : {"rod", "plate"}) {
    BodyResult body;
    body.name = name;
    body.elements = 8;
    body.eroded_elements = step;
    body.mass_initial = 1.0;
    body.mass_remaining = 1.0 - 0.1 * static_cast<double>(step);
    body.velocity = {10.0 + time, 0.0, -10.0};
    body.max_plastic_strain = 1.0 / 3.0;
    row.bodies.push_back(body);
  }
  return row;
}

}  // namespace pinball::test
