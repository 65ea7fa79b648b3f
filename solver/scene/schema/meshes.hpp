#pragma once

#include <array>
#include <string>
#include <string_view>

#include "../../mesh_settings.hpp"
#include "key.hpp"

/// The keys of meshes. That of a body says by `type` which of these it is.
namespace pinball::schema {

/// Three numbers, or lists of numbers in their places: [1, 1, [0.4, 0.2, 0.4]].
template <class Number>
struct ListsOf {};

/// [p, q] of a wedge, else one number.
struct OneOrTwoCounts {};

inline constexpr std::array<std::string_view, 4> mesh_types{"block", "round_nosed_rod", "cylinder", "sphere"};

inline constexpr About count_of_elements{.unit = "-", .bound = {.low = 1}, .need = Need::required, .form = Form::count};
inline constexpr About optional_count{.unit = "-", .bound = {.low = 1}, .form = Form::count};
inline constexpr About length_of_mesh{.unit = "L", .bound = positive, .need = Need::required};
inline constexpr About angle_of_wedge{
    .unit = "degree", .bound = {.low = 0.0, .low_open = true, .high = largest_wedge_angle}, .need = Need::required};

inline constexpr const char* not_in_wedge = "where section = \"wedge\", which has radial";
inline constexpr const char* only_in_wedge = "where section is not \"wedge\"";

/// What only wedges, or only the other sections have.
template <class Mesh>
constexpr bool is_wedge(const Mesh& mesh) {
  return mesh.section == Section::wedge;
}
template <class Mesh>
constexpr bool is_no_wedge(const Mesh& mesh) {
  return mesh.section != Section::wedge;
}

template <class Visit>
constexpr void describe(Of<BlockMesh>, Visit&& visit) {
  describe_type(visit, mesh_types[0]);
  visit(FileKey<ListsOf<double>>{"size", "`[lx, ly, lz]`", length_of_mesh});
  visit(FileKey<ListsOf<int>>{"elements", "`[nx, ny, nz]`", count_of_elements});
  visit(Field{"size", &BlockMesh::size, "[length]"});
  visit(Field{"elements", &BlockMesh::elements, "along each direction"});
  visit(Field{"sections", &BlockMesh::sections,
              "per direction, whose sums are size and elements; empty: elements of one size"});
}

template <class Visit>
constexpr void describe(Of<RoundNosedRodMesh>, Visit&& visit) {
  using T = RoundNosedRodMesh;
  describe_type(visit, mesh_types[1]);
  visit(Key{"length", &T::length, "over all, > `radius`", length_of_mesh});
  visit(Key{"radius", &T::radius, "of the rod and of the nose", length_of_mesh});
  visit(Key{"half", &T::half, "only y >= 0, with the flat cut in y = 0"});
  visit(Key{"core", &T::core, "elements of the core along x and y (of the half section)", optional_count});
  visit(Key{"ring", &T::ring, "layers of elements between the core and the surface", optional_count});
  visit(Key{"layers", &T::layers, "layers of elements along the axis", count_of_elements});
}

template <class Visit>
constexpr void describe(Of<CylinderMesh>, Visit&& visit) {
  using T = CylinderMesh;
  describe_type(visit, mesh_types[2]);
  visit(Key{"radius", &T::radius, "of the cylinder", length_of_mesh});
  visit(Key{"length", &T::length, "along its axis", length_of_mesh});
  visit(Key{"section", &T::section,
            "`\"half\"` (y >= 0), `\"quarter\"` (x >= 0 and y >= 0) or `\"wedge\"` (from y = 0 by `angle`)"});
  visit(Key{"core", &T::core, "elements along each side of the full core, even in `half` and `quarter`; not in a wedge",
            count_of_elements}
            .only_where(is_no_wedge, not_in_wedge));
  visit(Key{"ring", &T::ring, "layers of elements between the core and the surface; not in a wedge", optional_count}
            .only_where(is_no_wedge, not_in_wedge));
  visit(Key{"angle", &T::angle, "of the wedge, and only there", angle_of_wedge}.only_where(is_wedge, only_in_wedge));
  visit(
      Key{"radial", &T::radial, "elements of the wedge along the radius, and only there", count_of_elements}.only_where(
          is_wedge, only_in_wedge));
  visit(Key{"layers", &T::layers, "layers of elements along the axis", count_of_elements});
}

template <class Visit>
constexpr void describe(Of<SphereMesh>, Visit&& visit) {
  using T = SphereMesh;
  describe_type(visit, mesh_types[3]);
  visit(Key{"radius", &T::radius, "of the sphere", length_of_mesh});
  visit(Key{"section", &T::section, "as of the cylinder; a wedge is about the body's z axis"});
  visit(Key{"angle", &T::angle, "of the wedge, and only there", angle_of_wedge}.only_where(is_wedge, only_in_wedge));
  visit(FileKey<OneOrTwoCounts>{
      "core",
      "elements along each side of the full core, even in `half` and `quarter`; in a wedge `[p, q]`: along the radius "
      "and along the axis (of its whole height)",
      count_of_elements});
  visit(Field{"core", &T::core, "elements along the sides of the core"});
  visit(Key{"ring", &T::ring, "layers of elements between the core and the surface", optional_count});
  visit(Key{"grading",
            &T::grading,
            "elements at the pole z = -`radius` are smaller by this factor, those at the other one larger",
            {.unit = "-", .bound = {.low = 0.0, .low_open = true, .high = 1.0}}});
}

/// Of any format; `type` names it, or is "file" where the ending of the file does.
template <class Visit>
constexpr void describe(Of<FileMesh>, Visit&& visit) {
  using T = FileMesh;
  visit(FileKey<std::string>{"type", "what it is", {.need = Need::required}});
  visit(Field{"format", &T::format, "of the file"});
  visit(Key{"file", &T::file, "relative to the folder of the scene file", {.need = Need::required}});
  visit(Key{"physical",
            &T::part,
            "name or number of the physical volume that is the body; `part` with `type = \"file\"`",
            {.otherwise = "all volumes", .field = "part"}}
            .only_where([](const FileMesh& mesh) { return mesh.format == MeshFormat::gmsh; }));
  visit(Key{"part", &T::part, "name or number of a part, or of a set of elements", {.otherwise = "all elements"}}
            .only_where([](const FileMesh& mesh) { return mesh.format != MeshFormat::gmsh; }));
  visit(Key{"case",
            &T::chosen_case,
            "number of a `*CASE`: its nodes, elements and sets are read, too",
            {.bound = {.low = 0}, .field = "chosen_case", .listed = Listed::where_given}}
            .only_where([](const FileMesh& mesh) { return mesh.format == MeshFormat::keyword; }));
  visit(Key{"array",
            &T::array,
            "name of the integers of the cells that number the parts",
            {.otherwise = "the first of known names"}}
            .only_where([](const FileMesh& mesh) { return mesh.format == MeshFormat::vtk; }));
  visit(Field{"splits", &T::splits, "so often each hexahedron is split in eight"});
  visit(Key{"scale", &T::scale, "multiplies the coordinates", {.unit = "-", .bound = positive}});
}

}  // namespace pinball::schema
