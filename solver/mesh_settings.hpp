#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "array_view.hpp"
#include "base/point.hpp"
#include "mesh_formats.hpp"

/// What a mesh is made from: settings of the generators, a file, or arrays of a host. Fields carry the TOML key that
/// sets them; lengths are in the scene's unit.
namespace pinball {

/// Layers of elements of one thickness across a block.
struct BlockSection {
  double length = 0.0;
  int elements = 0;
};

/// mesh = { type = "block", size = [lx, ly, lz], elements = [nx, ny, nz] }: corner at the origin of the body's frame.
/// Lists in the places of a size and a number of elements cut that direction into sections.
struct BlockMesh {
  Point size{};
  std::array<int, 3> elements{};
  std::array<std::vector<BlockSection>, 3> sections{};  ///< empty: elements of one size along that direction
};

/// mesh = { type = "round_nosed_rod", length, radius, half = true, core = [p, q], ring = b, layers = n }.
/// The axis is the body's z, the tip of the hemispherical nose at the origin, the rod behind it at z < 0 ... -length;
/// with half = true only y >= 0 is meshed and the flat cut lies in y = 0.
struct RoundNosedRodMesh {
  double length = 0.0;
  double radius = 0.0;
  bool half = true;
  std::array<int, 2> core{2, 2};  ///< elements of the core block along x and along y (of the half section)
  int ring = 1;                   ///< layers of elements between the core and the lateral surface and nose
  int layers = 1;                 ///< layers of elements along the axis
};

/// Part of a body of revolution about z: all of it, y >= 0, x >= 0 and y >= 0, or from y = 0 turned by an angle.
enum class Section { full, half, quarter, wedge };

/// A wedge has one element around its angle; beyond this [degree] its elements are too blunt.
inline constexpr double largest_wedge_angle = 60.0;

/// mesh = { type = "cylinder", radius, length, section = "full", core = c, ring = b, layers = n }; with
/// section = "wedge": angle, radial and layers. The axis is the body's z, from 0 to length.
struct CylinderMesh {
  double radius = 0.0;
  double length = 0.0;
  Section section = Section::full;
  double angle = 0.0;  ///< of the wedge [degree]
  int core = 1;        ///< elements along each side of the full core
  int ring = 1;        ///< layers of elements between the core and the surface
  int radial = 1;      ///< elements of the wedge along the radius
  int layers = 1;      ///< layers of elements along the axis
};

/// mesh = { type = "sphere", radius, section = "full", core = c, ring = b, grading = 1 }; with section = "wedge":
/// core = [p, q] and angle. The centre is the origin, wedges are about the body's z axis.
struct SphereMesh {
  double radius = 0.0;
  Section section = Section::full;
  double angle = 0.0;             ///< of the wedge [degree]
  std::array<int, 2> core{1, 1};  ///< elements along each side of the full core; of the wedge's along radius and axis
  int ring = 1;                   ///< layers of elements between the core and the surface
  double grading = 1.0;           ///< elements at the pole z = -radius are smaller by this factor [-]
};

class HeldMesh;  // solver/mesh/held_mesh.hpp: not for hosts

/// mesh = { type = "gmsh", file = "part.msh", physical = "name", scale = 1 }, or of another type, with part in the
/// place of physical. Bodies of one file with the same case, scale, axis and position share the nodes that their
/// elements have in common.
struct FileMesh {
  MeshFormat format = MeshFormat::gmsh;
  std::string file;    ///< as it can be opened; in the scene relative to the folder of the scene file
  std::string part;    ///< part, physical: name or number of a part or of a set of elements; default: all elements
  double scale = 1.0;  ///< multiplies the coordinates
  std::optional<std::int64_t> chosen_case{};  ///< case: of a deck; none: what belongs to no case
  std::string array{};               ///< of vtk: the integers of the cells that number the parts; default: by its name
  std::shared_ptr<HeldMesh> held{};  ///< of a deck that is being run: what was read with it; null: the file is read
  int splits = 0;  ///< so often each hexahedron is split in eight (mesh/file/split_hexahedra.hpp); files have no key
};

/// The mesh of a body in the memory of a host. It is read, and copied once, while the model is built: elements are
/// sorted then. Until that is done the arrays have to stay; afterwards nothing refers to them.
struct ArrayMesh {
  ConstArrayView coordinates{};  ///< records of three floats or doubles, one per node [length]
  /// Records of eight 32- or 64-bit integers, one per element: places in `coordinates`, in the order of corners that
  /// mesh.hpp shows.
  ConstArrayView hexahedra{};
  std::int64_t first_index = 0;         ///< what `hexahedra` calls the first node: 1 in Fortran
  std::shared_ptr<const void> owner{};  ///< keeps the arrays while they may be read; none: the host sees to that
};

/// ArrayMesh has no form in TOML: it is for hosts.
using MeshSettings = std::variant<BlockMesh, RoundNosedRodMesh, CylinderMesh, SphereMesh, FileMesh, ArrayMesh>;

}  // namespace pinball
