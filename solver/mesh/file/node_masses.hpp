#pragma once

#include <vector>

#include <solver/mesh/mesh_file.hpp>

namespace pinball {

/// Masses at the nodes of a file, their shares of that of each of their elements. density: per part [mass/length^3].
std::vector<double> node_masses(const MeshFile& file, const std::vector<double>& density);

}  // namespace pinball
