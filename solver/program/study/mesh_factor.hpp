#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solver/scene.hpp>

/// Scenes on finer and coarser meshes: the numbers of elements that --refine multiplies, times a fraction.
namespace pinball {

/// What multiplies the numbers of elements in each direction, in lowest terms.
struct MeshFactor {
  int numerator = 1, denominator = 1;

  double value() const { return static_cast<double>(numerator) / denominator; }
  std::string text() const;  ///< "3/2", "2"
  bool operator==(const MeshFactor&) const = default;
};

/// "1/2,1,2", from coarse to fine. Throws InputError where there are fewer than three, two of one size, or anything
/// else than positive fractions.
std::vector<MeshFactor> parse_mesh_factors(const std::string& text);

/// Those of a scene whose user names none, in a constant ratio: 1/2, 1, 2 where all numbers of elements can be halved,
/// else 1, 2, 4, as with a mesh of a file.
std::vector<MeshFactor> default_mesh_factors(const Scene& scene);

/// Throws InputError that names the key where meshes of other sizes would not be those of the same problem: time.steps,
/// loads on each node; with meshes of files also what numbered_sets.hpp cannot carry.
void require_refinable(const Scene& scene);

/// The scene with its meshes in that many elements; those of files are split so often in eight. Throws InputError that
/// names the body and the number which that does not leave whole, or not even where a section is cut through it, and
/// for meshes of files where it is no power of two.
Scene refined_by(const Scene& scene, const MeshFactor& factor);

/// The same with one body alone. Throws InputError for a name that no body has, too, and for a body whose file is that
/// of others, with whose elements its own would no longer share nodes.
Scene refined_body(const Scene& scene, const std::string& body, const MeshFactor& factor);

/// The least factor from `least` to `most` that refined_by() takes, of denominators up to 8; none: there is none.
std::optional<MeshFactor> least_mesh_factor(const Scene& scene, double least, double most);

/// "bar: core 8, ring 4, layers 80; plate: elements 10 x 10 x 2; tube: tube.msh, each element in 8".
std::string element_counts(const Scene& scene);

}  // namespace pinball
