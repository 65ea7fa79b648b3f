#include "base_of_fields.hpp"
#include "simulation_implementation.hpp"

namespace pinball {

namespace {

using Numbers = std::vector<std::pair<std::int64_t, std::int32_t>>;

/// Of all files; empty where none has any.
std::vector<std::int64_t> numbers_of(const ModelMesh& mesh, Numbers FileNodes::*numbers, std::size_t count) {
  std::vector<std::int64_t> result;
  for (const FileNodes& file : mesh.files) {
    if (!(file.*numbers).empty()) result.resize(count, -1);
    for (const auto& [number, place] : file.*numbers) result[place] = number;
  }
  return result;
}

}  // namespace

FieldBase base_of_fields(const ModelMesh& mesh) {
  return {mesh.nodes, numbers_of(mesh, &FileNodes::numbers, mesh.nodes.size()),
          numbers_of(mesh, &FileNodes::element_numbers, mesh.hexahedra.size())};
}

FieldBase Simulation::field_base() const {
  return base_of_fields(*implementation_->read([](const auto& solver) { return &solver.mesh(); }));
}

}  // namespace pinball
