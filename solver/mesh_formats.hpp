#pragma once

#include <array>
#include <string_view>

namespace pinball {

/// Formats of files that hold a mesh. vtk: legacy files (.vtk) and those of XML (.vtu), which the first bytes tell
/// apart.
enum class MeshFormat { gmsh, keyword, exodus, vtk, abaqus, radioss };

/// What is known of a format, but for how it is read (solver/formats/mesh_reader.cpp).
struct KnownMeshFormat {
  MeshFormat format;
  const char* name;          ///< `type` of a mesh of it
  std::string_view endings;  ///< of its files, blanks between
  bool is_of_decks = false;  ///< its files may also say what touches and what acts
};

inline constexpr std::array known_mesh_formats{
    KnownMeshFormat{MeshFormat::gmsh, "gmsh", ".msh"},
    KnownMeshFormat{MeshFormat::keyword, "keyword", ".k .key .dyn", true},
    KnownMeshFormat{MeshFormat::exodus, "exodus", ".g .e .exo .ex2 .gen"},
    KnownMeshFormat{MeshFormat::vtk, "vtk", ".vtk .vtu"},
    KnownMeshFormat{MeshFormat::abaqus, "abaqus", ".inp", true},
    KnownMeshFormat{MeshFormat::radioss, "radioss", ".rad", true},
};

constexpr bool is_of_decks(MeshFormat format) {
  for (const KnownMeshFormat& known : known_mesh_formats) {
    if (known.format == format) return known.is_of_decks;
  }
  return false;
}

}  // namespace pinball
