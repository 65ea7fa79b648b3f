#include "gmsh_types.hpp"

#include <fmt/format.h>

#include <array>

/// "MSH file format" in the reference manual of Gmsh.
namespace pinball::gmsh {
namespace {

struct Type {
  int dimension, nodes;
  const char* form;
};

constexpr std::array<Type, 32> types{{
    {3, 0, "elements"},    {1, 2, "lines"},       {2, 3, "triangles"},  {2, 4, "quadrangles"}, {3, 4, "tetrahedra"},
    {3, 8, "hexahedra"},   {3, 6, "prisms"},      {3, 5, "pyramids"},   {1, 3, "lines"},       {2, 6, "triangles"},
    {2, 9, "quadrangles"}, {3, 10, "tetrahedra"}, {3, 27, "hexahedra"}, {3, 18, "prisms"},     {3, 14, "pyramids"},
    {0, 1, "points"},      {2, 8, "quadrangles"}, {3, 20, "hexahedra"}, {3, 15, "prisms"},     {3, 13, "pyramids"},
    {2, 9, "triangles"},   {2, 10, "triangles"},  {2, 12, "triangles"}, {2, 15, "triangles"},  {2, 15, "triangles"},
    {2, 21, "triangles"},  {1, 4, "lines"},       {1, 5, "lines"},      {1, 6, "lines"},       {3, 20, "tetrahedra"},
    {3, 35, "tetrahedra"}, {3, 56, "tetrahedra"},
}};

const Type& type_of(std::int64_t type) { return types[type > 0 && type < std::ssize(types) ? type : 0]; }

}  // namespace

int nodes_of(std::int64_t type) { return type == 92 ? 64 : type == 93 ? 125 : type_of(type).nodes; }
int dimension_of(std::int64_t type) { return type_of(type).dimension; }

std::string name_of(std::int64_t type) {
  if (type == 92 || type == 93) return fmt::format("{}-node hexahedra", nodes_of(type));
  const Type& known = type_of(type);
  return known.nodes == 0 ? known.form : fmt::format("{}-node {}", known.nodes, known.form);
}

}  // namespace pinball::gmsh
