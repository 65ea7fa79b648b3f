#include "mesh_format.hpp"

#include <cctype>
#include <filesystem>
#include <utility>
#include <vector>

namespace pinball {

namespace {

const std::vector<std::pair<std::string, MeshFormat>> endings{
    {".msh", MeshFormat::gmsh},    {".k", MeshFormat::keyword},  {".key", MeshFormat::keyword},
    {".dyn", MeshFormat::keyword}, {".g", MeshFormat::exodus},   {".e", MeshFormat::exodus},
    {".exo", MeshFormat::exodus},  {".ex2", MeshFormat::exodus}, {".gen", MeshFormat::exodus},
    {".vtk", MeshFormat::vtk},     {".vtu", MeshFormat::vtk},    {".inp", MeshFormat::abaqus},
    {".rad", MeshFormat::radioss},
};

}  // namespace

std::optional<MeshFormat> format_by_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const auto& [known, format] : endings) {
    if (known == ending) return format;
  }
  return {};
}

std::string known_endings() {
  std::string all;
  for (const auto& [known, format] : endings) all += (all.empty() ? "" : ", ") + known;
  return all;
}

}  // namespace pinball
