#include "vtk_reader.hpp"

#include <cstdint>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/mesh/file/input_file.hpp>

namespace pinball {

MeshFile parse_vtk(std::string bytes, const std::string& name, const std::string& array,
                   const std::vector<std::string>& parts) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  VtkGrid grid;
  if (bytes.starts_with("# vtk DataFile")) {
    grid = parse_vtk_legacy(bytes, name);
  } else if (first != std::string::npos && bytes[first] == '<') {
    grid = parse_vtu(bytes, name);
  } else {
    throw InputError(name + ":1: expected \"# vtk DataFile\" or <VTKFile ...>");
  }
  std::string().swap(bytes);  // its memory is needed for the mesh
  return mesh_of_grid(std::move(grid), name, array, parts);
}

MeshFile read_vtk(const std::string& path, const std::string& array, const std::vector<std::string>& parts) {
  std::string bytes = bytes_of_file(path);
  const std::uint64_t hash = hash_of_bytes(bytes);  // reading XML changes them
  MeshFile file = parse_vtk(std::move(bytes), path, array, parts);
  file.sources = {{path, hash}};
  return file;
}

}  // namespace pinball
