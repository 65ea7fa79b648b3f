#pragma once

#include <cstdint>
#include <vector>

#include <solver/mesh/generators.hpp>
#include <solver/scene.hpp>

namespace pinball::test {

/// A mesh as a host has it: coordinates and connectivity in arrays of its own.
template <class Index = std::int32_t>
struct HostMesh {
  std::vector<double> coordinates;
  std::vector<Index> hexahedra;
  Index first_index = 0;

  HostMesh(const Mesh& mesh, Index first) : first_index(first) {
    for (const Point& node : mesh.nodes) coordinates.insert(coordinates.end(), node.begin(), node.end());
    for (const auto& corners : mesh.hexahedra) {
      for (const std::int32_t node : corners) hexahedra.push_back(node + first);
    }
  }
  ArrayMesh view() const {
    return {view_records(coordinates.data(), static_cast<std::int64_t>(coordinates.size() / 3), 3),
            view_records(hexahedra.data(), static_cast<std::int64_t>(hexahedra.size() / 8), 8),
            first_index,
            {}};
  }
};

/// A scene whose bodies have the meshes of another scene in arrays, which live as long as this does.
template <class Index = std::int32_t>
struct ArrayScene {
  std::vector<HostMesh<Index>> meshes;
  Scene scene;

  explicit ArrayScene(const Scene& generated, Index first = 0) : scene(generated) {
    for (const Body& body : generated.bodies) meshes.emplace_back(generate(body.mesh), first);
    for (std::size_t b = 0; b < meshes.size(); ++b) scene.bodies[b].mesh = meshes[b].view();
  }
};

}  // namespace pinball::test
