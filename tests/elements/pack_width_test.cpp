#include <gtest/gtest.h>

#include <vector>

#include <solver/base/packs.hpp>
#include <solver/elements/tile_kernels_instances.hpp>
#include <tests/support/support.hpp>

/// Sums of corner forces have the same bits for packs of any width. Compiled so that no multiplication is fused with an
/// addition: which are is another matter in each kernel.
namespace pinball::pack_width_test {
namespace {

constexpr ElementFeatures features{true, true, true, HourglassKind::stiffness};

/// Elements in a row of five, in layers: 45 of them that share nodes, the last pack of any width but one part padding.
template <class S>
struct Lattice {
  static constexpr int n[3] = {5, 3, 3};
  test::AlignedVector<S> position, velocity;
  std::vector<std::array<std::int32_t, 8>> corners;

  Lattice() {
    const auto node = [](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
    unsigned state = 1;
    const auto random = [&state] { return static_cast<S>((state = state * 1664525u + 1013904223u) >> 8) / S(1 << 24); };
    for (int k = 0; k <= n[2]; ++k) {
      for (int j = 0; j <= n[1]; ++j) {
        for (int i = 0; i <= n[0]; ++i) {
          for (const int c : {i, j, k}) position.push_back(S(c) + S(0.2) * random());
          for (int c = 0; c < 3; ++c) velocity.push_back(random() - S(0.5));
          position.push_back(0);
          velocity.push_back(0);
        }
      }
    }
    for (int k = 0; k < n[2]; ++k) {
      for (int j = 0; j < n[1]; ++j) {
        for (int i = 0; i < n[0]; ++i) {
          corners.push_back({node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                             node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
                             node(i, j + 1, k + 1)});
        }
      }
    }
  }
};

/// Forces of the nodes after one step, in packs of W. N: the numbers of nodes.
template <class S, int W, class N>
std::vector<N> forces_of_packs() {
  const Lattice<N> lattice;
  const std::size_t count = lattice.corners.size(), packs = (count + W - 1) / W;
  test::AlignedVector<std::int32_t> corner(8 * packs * W);
  test::AlignedVector<S> mass(packs * W, S(0)), stress(6 * packs * W, S(0)), plastic(packs * W, S(0));
  test::AlignedVector<S> hourglass(12 * packs * W, S(0)), viscous(packs * W, S(0)), energy(packs * W, S(0));
  test::AlignedVector<N> force(lattice.position.size(), N(0));
  for (std::size_t e = 0; e < packs * W; ++e) {
    const std::size_t real = std::min(e, count - 1);
    if (e == real) mass[e] = S(3);
    for (int i = 0; i < 8; ++i) {
      corner[place_in_packs<W>(static_cast<std::int64_t>(e), i, 8)] =
          lattice.corners[real][static_cast<std::size_t>(i)];
    }
  }
  ElementConstants<S> constants{};
  constants.material = {S(150), S(80), S(30), S(10), S(1e30), S(3), S(10)};
  constants.viscosity.linear = S(0.06);
  constants.viscosity.quadratic = S(1.2);
  constants.hourglass.modulus = S(7);
  constants.specific_volume = S(1) / S(3);
  const TilePacks<S, N> tile{
      {corner.data(), mass.data(), stress.data(), plastic.data(), hourglass.data(), viscous.data(), energy.data()},
      {lattice.position.data(), lattice.velocity.data(), force.data()},
      constants,
      {S(0.05)},
      0,
      static_cast<std::int64_t>(packs)};
  TileResult<N> result;
  update_packs<Pack<S, W>, features>(tile, result);
  EXPECT_EQ(result.inverted_count, 0);
  return {force.begin(), force.end()};
}

template <class S, int W, class N = S>
void expect_bits_of_widest() {
  const std::vector<N> widest = forces_of_packs<S, widest_pack<S>, N>(), others = forces_of_packs<S, W, N>();
  int other_bits = 0;
  for (std::size_t i = 0; i < widest.size(); ++i) other_bits += widest[i] == others[i] ? 0 : 1;
  EXPECT_EQ(other_bits, 0) << "of " << widest.size() << " with packs of " << W;
}

TEST(PackWidth, AddsDoublesWithTheSameBits) {
  expect_bits_of_widest<double, 1>();
  expect_bits_of_widest<double, 2>();
  expect_bits_of_widest<double, 4>();
}

TEST(PackWidth, AddsFloatsWithTheSameBits) {
  expect_bits_of_widest<float, 1>();
  expect_bits_of_widest<float, 4>();
  expect_bits_of_widest<float, 8>();
}

/// The elements of the widest pack are fetched by rows, those of others are not.
TEST(PackWidth, AddsMixedPrecisionWithTheSameBits) {
  expect_bits_of_widest<float, 1, double>();
  expect_bits_of_widest<float, 4, double>();
  expect_bits_of_widest<float, 8, double>();
}

}  // namespace
}  // namespace pinball::pack_width_test
