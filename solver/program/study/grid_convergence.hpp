#pragma once

#include <array>
#include <optional>
#include <vector>

namespace pinball {

/// A quantity on one mesh.
struct MeshValue {
  double size = 0;  ///< of an element, of any unit that all meshes share; > 0
  double value = 0;
};

enum class Convergence {
  constant,     ///< all values are the same to round-off
  monotone,     ///< the three finest meshes converge from one side
  oscillating,  ///< they come from both sides
  diverging,    ///< the differences do not become smaller as they should with any positive order
};

struct GridConvergence {
  Convergence verdict = Convergence::constant;
  /// p in value = exact + C h^p through the three finest meshes; infinite where the two finest agree to round-off, none
  /// where nothing converges [-].
  std::optional<double> observed_order;
  /// The observed one within [0.5, formal order], which the figures below are of [-].
  double order = 0;
  /// 1.25 where the observed order is 0.9 to 1.05 of the formal one, else 3 [-].
  double safety_factor = 0;
  double extrapolated = 0;        ///< value at h = 0; where nothing converges that of the finest mesh
  double approximate_error = 0;   ///< |fine - next| / |fine|, not finite where the fine value is 0 [-]
  double extrapolated_error = 0;  ///< |extrapolated - fine| / |extrapolated| [-]
  double index = 0;               ///< grid convergence index: half the width of the band over |fine| [-]
  /// The band, fine value -+ index |fine|; where nothing converges no band, but the least and largest value of all
  /// meshes.
  double low = 0, high = 0;

  /// Whether the order of the band is not the observed one: the meshes are too coarse, or agree by chance.
  bool order_is_bounded() const { return verdict == Convergence::monotone && order != observed_order; }
  bool has_band() const { return verdict == Convergence::monotone || verdict == Convergence::constant; }
};

/// What meshes say of a quantity: the procedure of Celik, Ghia, Roache, Freitas, Coleman and Raad, J. Fluids Engrg. 130
/// (2008) 078001, after Roache, J. Fluids Engrg. 116 (1994) 405, for ratios of sizes that may differ.
///
///   epsilon_32 / epsilon_21 = r21^p (r32^p - 1) / (r21^p - 1),  epsilon_ij = value_i - value_j,  r_ij = h_i / h_j
///
/// has the observed order p as its root: the equation of that paper. The right side rises with p from ln r32 / ln r21,
/// so that the root is bracketed; the paper's fixed-point iteration comes to the same, but not where r32 > r21^2.
/// Then extrapolated = value_1 + (value_1 - value_2) / (r21^p - 1) and index = F |value_1 - value_2| / |value_1|
/// / (r21^p - 1), with F = 1.25 where the observed order is the formal one: not below 0.9 of it (Oberkampf and Roy,
/// Verification and Validation in Scientific Computing, 2010, section 8.6), not above 1.05 of it (Eca and Hoekstra,
/// J. Comput. Phys. 262 (2014) 104). What else is observed says that the meshes are not in the asymptotic range, or
/// that the answer has fronts or edges: F = 3, with an order of 0.5 at least and the formal one at most. Celik and
/// others have F = 1.25 for all: of 35 numbers that are known such bands leave out 16, these 10 (docs/accuracy.md).
/// Since two meshes may agree by chance, the band of an order beyond the formal one is not narrower than the one that
/// the two coarser meshes give with that.
///
/// values: of three meshes at least, of different sizes, in any order; the three finest count, but for the spread.
/// scale: what round-off is measured by; at least the largest value is. round_off: differences up to this part of it
/// are none. Throws std::invalid_argument where there are fewer values or two of one size.
GridConvergence grid_convergence(std::vector<MeshValue> values, double scale = 0, double round_off = 1e-10,
                                 double formal_order = 2);

/// The same of what has no difference but a distance, such as curves over time: the value of a mesh is its distance
/// from what elements of no size would give, 0 is the extrapolated one, and the band goes from there to the largest
/// that the finest mesh may have. sizes: of the three finest meshes, from fine to coarse; e21 and e32: distances
/// between neighbours. Nothing oscillates.
GridConvergence distance_convergence(const std::array<double, 3>& sizes, double e21, double e32, double scale,
                                     double round_off = 1e-10, double formal_order = 2);

}  // namespace pinball
