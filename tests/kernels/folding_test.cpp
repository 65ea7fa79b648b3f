#include <Eigen/Dense>

#include <kernels/folding.hpp>
#include <kernels/stable_time_step.hpp>
#include <tests/support/support.hpp>

/// Corners of hexahedra that are about to turn over: when they are looked at, what resists, and how stiffly.
namespace pinball::folding_test {
namespace {

using namespace test;

constexpr double onset = 0.3, energy_scale = 0.7, inverse_mass = 2.0;

double volume_of(const Corners& x) {
  Vec3<double> corner[8];
  std::copy(x.begin(), x.end(), corner);
  const HexahedronModes<double> modes = to_modes(corner);
  return hexahedron_volume(uniform_gradient(modes), modes);
}

/// The element by itself: nodes are its corners.
CornerResistance<double> resistance(const Corners& x, const Corners& v = {}, double r0 = onset) {
  alignas(32) double position[32] = {}, velocity[32] = {};
  const std::int32_t corner[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3<double> of[2] = {x[i], v[i]};
    double* const to[2] = {position + 4 * i, velocity + 4 * i};
    for (int k = 0; k < 2; ++k) to[k][0] = of[k].x, to[k][1] = of[k].y, to[k][2] = of[k].z;
  }
  CornerResistance<double> out{};
  Vec3<double> at[8];
  std::copy(x.begin(), x.end(), at);
  resist_folding<double, 1>(position, velocity, corner, energy_scale, r0, inverse_mass, to_modes(at), volume_of(x),
                            true, out);
  return out;
}

/// The least share of a corner, from the edges as the numbering of corners gives them.
double least_share(const Corners& x) {
  constexpr int next[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  double least = 8;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto edge = [&](int n) { return x[static_cast<std::size_t>(n)] - x[i]; };
    least = std::min(least, dot(edge(next[i][0]), cross(edge(next[i][1]), edge(next[i][2]))) / volume_of(x));
  }
  return least;
}

/// A box of random size and place whose corners are moved by up to so much of its edges.
Corners distorted(Random& random, double by) {
  Corners x = box(uniform(random, 0.2, 3), uniform(random, 0.2, 3), uniform(random, 0.2, 3));
  const Vec3<double> a = x[6] - x[0];
  for (Vec3<double>& p : x) {
    p = p +
        Vec3<double>{a.x * uniform(random, -by, by), a.y * uniform(random, -by, by), a.z * uniform(random, -by, by)};
  }
  const Tensor<double> r = rotation_matrix(random_direction(random), uniform(random, 0, 6));
  for (Vec3<double>& p : x) p = r * p + Vec3<double>{4, -2, 1};
  return x;
}

/// Those with a volume and a corner below the onset, but not far beyond zero.
Corners near_folding(Random& random) {
  for (;;) {
    const Corners x = distorted(random, 0.5);
    if (volume_of(x) > 0.05 && least_share(x) < onset && least_share(x) > 0.02) return x;
  }
}

double& component(Corners& x, int number) {
  Vec3<double>& p = x[static_cast<std::size_t>(number / 3)];
  return number % 3 == 0 ? p.x : number % 3 == 1 ? p.y : p.z;
}

Eigen::VectorXd forces(const CornerResistance<double>& found) {
  Eigen::VectorXd f(24);
  for (int i = 0; i < 8; ++i) f.segment<3>(3 * i) << found.force[i].x, found.force[i].y, found.force[i].z;
  return f;
}

TEST(Folding, TheLeastCornerIsThatOfTheEdgesThere) {
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    const Corners x = distorted(random, 0.6);
    if (!(volume_of(x) > 0.01)) continue;
    const double exact = least_share(x), tolerance = 1e-12 * (1 + std::abs(exact));
    Vec3<double> corner[8];
    std::copy(x.begin(), x.end(), corner);
    ASSERT_NEAR(least_corner_share(corner, volume_of(x)), exact, tolerance);
    ASSERT_NEAR(resistance(x).worst, exact, tolerance);
  }
}

TEST(Folding, NoElementWithACornerBelowTheOnsetIsPassedOver) {
  Random random(2);
  int near = 0, sound = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    const Corners x = distorted(random, uniform(random, 0, 0.4));
    Vec3<double> corner[8];
    std::copy(x.begin(), x.end(), corner);
    const HexahedronModes<double> modes = to_modes(corner);
    const UniformGradient<double> b = uniform_gradient(modes);
    const double volume = hexahedron_volume(b, modes);
    if (!(volume > 0)) continue;
    const bool passed = largest_distortion(modes, largest_principal_value(gradient_square(b))) <
                        sound_distortion<double> * volume * volume;
    sound += passed ? 1 : 0;
    if (least_share(x) > folding_onset<double>) continue;
    ++near;
    ASSERT_FALSE(passed) << least_share(x);
  }
  EXPECT_GT(near, 20000);
  EXPECT_GT(sound, 10000);
}

/// Boxes of any proportions, stretched and sheared, with modes so large that the bound of their directions is just met:
/// also such that one corner takes as much as it may from all of its edges.
TEST(Folding, NoElementWithACornerBelowTwiceTheOnsetIsPassedOverByTheCloserBound) {
  Random random(3);
  double least = 1;
  int passed_over_by_the_other = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    HexahedronModes<double> modes{};
    double edge[3][3];
    for (int m = 0; m < 3; ++m) {
      for (int k = 0; k < 3; ++k) edge[m][k] = (m == k ? 1 : 0) + uniform(random, -0.3, 0.3);
      const double length = std::pow(10, uniform(random, -1, 1));
      modes.linear[m] = {length * edge[m][0], length * edge[m][1], length * edge[m][2]};
    }
    const bool towards_a_corner = trial % 2 == 0;
    for (int a = 0; a < 4; ++a) {
      const double own = a < 3 ? 1 : 0.2;  // of the edges: what the two modes of an edge and the fourth take together
      modes.hourglass[a] = {0, 0, 0};
      for (int m = 0; m < 3; ++m) {
        const double part =
            towards_a_corner ? (m == a ? 0 : -own) + uniform(random, -0.1, 0.1) : uniform(random, -1, 1);
        modes.hourglass[a] = modes.hourglass[a] + part * modes.linear[m];
      }
    }
    const auto scaled = [&](double factor) {
      HexahedronModes<double> x = modes;
      for (Vec3<double>& h : x.hourglass) h = factor * h;
      return x;
    };
    const auto is_open = [](const HexahedronModes<double>& x) {
      const UniformGradient<double> b = uniform_gradient(x);
      const double volume = hexahedron_volume(b, x);
      return volume > 0 && directed_distortion(x, gradient_square(b)) < open_distortion<double> * volume * volume;
    };
    double open = 0, closed = 2;
    for (int i = 0; i < 40; ++i) (is_open(scaled(0.5 * (open + closed))) ? open : closed) = 0.5 * (open + closed);
    const HexahedronModes<double> x = scaled(open);
    const UniformGradient<double> b = uniform_gradient(x);
    const double volume = hexahedron_volume(b, x);
    Vec3<double> corner[8];
    Vec3<double> hourglass[4];
    for (int a = 0; a < 4; ++a) hourglass[a] = 3.0 * x.hourglass[a];  // of places; of forces as they are
    from_modes(x.linear, hourglass, corner);
    EXPECT_VECTOR_NEAR(to_modes(corner).hourglass[3], x.hourglass[3], 1e-12);
    least = std::min(least, least_corner_share(corner, volume));
    const double bound = sound_distortion<double> * volume * volume;
    passed_over_by_the_other += largest_distortion(x, largest_principal_value(gradient_square(b))) < bound ? 1 : 0;
  }
  EXPECT_GT(least, 2 * 1.001 * folding_onset<double>);
  EXPECT_LT(least, 0.9);  // the worst are among them
  EXPECT_LT(passed_over_by_the_other, 20000);
}

TEST(Folding, ElementsAboveTheOnsetAreLeftAlone) {
  const CornerResistance<double> found = resistance(box(1, 2, 3), box(0.5, 1, 0));
  EXPECT_DOUBLE_EQ(found.worst, 1);
  EXPECT_EQ(found.energy, 0);
  EXPECT_EQ(found.rate_square, 0);
  EXPECT_EQ(found.closing_rate, 0);
  EXPECT_EQ(forces(found).norm(), 0);
}

TEST(Folding, ForcesAreMinusTheGradientOfTheEnergy) {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    Corners x = near_folding(random);
    const CornerResistance<double> found = resistance(x);
    ASSERT_GT(found.energy, 0);
    const double h = 1e-6;
    for (int c = 0; c < 24; ++c) {
      double& place = component(x, c);
      const double before = place;
      place = before + h;
      const double above = resistance(x).energy;
      place = before - h;
      const double below = resistance(x).energy;
      place = before;
      ASSERT_NEAR(forces(found)(c), -(above - below) / (2 * h), 1e-4 * forces(found).norm() + 1e-9);
    }
  }
}

TEST(Folding, ForcesHaveNeitherResultantNorMoment) {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const Corners x = near_folding(random);
    const CornerResistance<double> found = resistance(x);
    Vec3<double> sum{0, 0, 0}, moment{0, 0, 0};
    for (int i = 0; i < 8; ++i) {
      sum = sum + found.force[i];
      moment = moment + cross(x[static_cast<std::size_t>(i)], found.force[i]);
    }
    const double size = forces(found).norm();
    ASSERT_LT(std::sqrt(dot(sum, sum)), 1e-12 * size);
    ASSERT_LT(std::sqrt(dot(moment, moment)), 1e-11 * size);
  }
}

TEST(Folding, TheFrequencyIsBounded) {
  Random random(5);
  double largest = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Corners x = near_folding(random);
    Eigen::MatrixXd stiffness(24, 24);
    const double h = 1e-6;
    for (int c = 0; c < 24; ++c) {
      double& place = component(x, c);
      const double before = place;
      place = before + h;
      const Eigen::VectorXd above = forces(resistance(x));
      place = before - h;
      stiffness.col(c) = -(above - forces(resistance(x))) / (2 * h);
      place = before;
    }
    const Eigen::MatrixXd symmetric = 0.5 * (stiffness + stiffness.transpose());
    const double exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues()(23);
    largest = std::max(largest, 8 * inverse_mass * exact / resistance(x).rate_square);
  }
  EXPECT_LT(largest, 1.0);
  EXPECT_GT(largest, 0.5) << "a bound that is too large makes steps too small";
}

TEST(Folding, TheRateAtWhichACornerClosesIsThatOfItsJacobian) {
  Random random(6);
  for (int trial = 0; trial < 300; ++trial) {
    const Corners x = near_folding(random);
    Corners v = distorted(random, 0.5);
    for (Vec3<double>& p : v) p = 0.01 * (p - Vec3<double>{4, -2, 1});
    const double rate = resistance(x, v).closing_rate;
    // Of the product of three edges at one corner and the volume as it is: the corner that is least sets it, unless
    // another closes faster.
    constexpr int next[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
    double expected = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto jacobian = [&](double t) {
        const auto edge = [&](int n) {
          const auto k = static_cast<std::size_t>(n);
          return x[k] + t * v[k] - x[i] - t * v[i];
        };
        return dot(edge(next[i][0]), cross(edge(next[i][1]), edge(next[i][2])));
      };
      const double share = jacobian(0) / volume_of(x);
      if (share >= 2 * onset) continue;
      const double used = std::max(share, onset / 64);
      expected = std::max(expected, -(jacobian(1e-4) - jacobian(-1e-4)) / 2e-4 / volume_of(x) / used);
    }
    ASSERT_NEAR(rate, expected, 1e-6 * (1 + expected));
  }
}

TEST(Folding, HalfEdgesOfModesAreThoseOfCorners) {
  Random random(12);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners x = distorted(random, 0.4);
    Vec3<double> corner[8];
    std::copy(x.begin(), x.end(), corner);
    const HalfEdges<double> expected = half_edges(corner), found = half_edges(to_modes(corner));
    for (int m = 0; m < 3; ++m) {
      for (int e = 0; e < 4; ++e) {
        const Vec3<double> off = found.along[m][e] - expected.along[m][e];
        EXPECT_LT(dot(off, off), 1e-28) << m << e;
      }
    }
  }
}

TEST(Folding, WhereAllCornersAreOpenNothingIsDone) {
  Random random(13);
  int open = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Corners x = distorted(random, 0.3), v = distorted(random, 0.5);
    const CornerResistance<double> found = resistance(x, v);
    EXPECT_NEAR(found.worst, least_share(x), 1e-12);
    if (found.worst < 2 * onset * 1.002) continue;
    ++open;
    EXPECT_EQ(found.energy, 0);
    EXPECT_EQ(found.closing_rate, 0);
  }
  EXPECT_GT(open, 20);
  EXPECT_LT(open, 180);
}

TEST(Folding, ACornerThatHasTurnedOverIsPushedBack) {
  Corners x = box(1, 1, 1);
  x[6] = {0.25, 0.25, 0.25};  // beyond the plane of its neighbours
  ASSERT_LT(least_share(x), 0);
  const CornerResistance<double> found = resistance(x);
  EXPECT_LT(found.worst, 0);
  EXPECT_GT(dot(found.force[6], Vec3<double>{1, 1, 1}), 0);
}

TEST(Folding, CornersOfCollapsedElementsDoNotCount) {
  Corners wedge = box(1, 1, 1);
  wedge[3] = wedge[0];
  wedge[7] = wedge[4];
  const CornerResistance<double> found = resistance(wedge);
  EXPECT_GT(found.worst, 0.5);
  EXPECT_EQ(forces(found).norm(), 0);
}

TEST(Folding, NothingResistsWithoutAnOnset) {
  Random random(7);
  const Corners x = near_folding(random);
  EXPECT_LT(resistance(x, {}, 0).worst, onset);
  EXPECT_EQ(resistance(x, {}, 0).energy, 0);
  EXPECT_EQ(forces(resistance(x, {}, 0)).norm(), 0);
}

/// All lanes of a pack at once, of elements that resist and some that do not, with one that is not there.
TEST(Folding, LanesOfAPackAreThoseOfElementsAlone) {
  using T = Pack<double, native_width<double>>;
  constexpr int W = width_of<T>;
  Random random(8);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Corners> x, v;
    alignas(64) double position[32 * W] = {}, velocity[32 * W] = {};
    std::int32_t corner[8 * W];
    MaskOf<T> there(true);
    T volume(0);
    for (int lane = 0; lane < W; ++lane) {
      x.push_back(lane % 3 == 2 ? distorted(random, 0.1) : near_folding(random));
      v.push_back(distorted(random, 0.5));
      set_lane(volume, lane, volume_of(x.back()));
      if constexpr (W > 1) {
        if (lane == 1) there[1] = false;
      }
      for (int i = 0; i < 8; ++i) {
        const int node = 8 * lane + i;
        corner[i * W + lane] = node;
        const Vec3<double> of[2] = {x.back()[static_cast<std::size_t>(i)], v.back()[static_cast<std::size_t>(i)]};
        double* const to[2] = {position + 4 * node, velocity + 4 * node};
        for (int k = 0; k < 2; ++k) to[k][0] = of[k].x, to[k][1] = of[k].y, to[k][2] = of[k].z;
      }
    }
    CornerResistance<T> found{};
    Vec3<T> place[8];
    for (int i = 0; i < 8; ++i) place[i] = gather_vectors<T>(position, corner + i * W);
    resist_folding<T, W>(position, velocity, corner, T(energy_scale), T(onset), T(inverse_mass), to_modes(place),
                         volume, there, found);
    for (int i = 0; i < W; ++i) {
      if (W > 1 && i == 1) {
        EXPECT_EQ(lane(found.worst, i), -1);
        EXPECT_EQ(lane(found.energy, i), 0);
        EXPECT_EQ(lane(found.force[0].x, i), 0);
        continue;
      }
      const auto at = static_cast<std::size_t>(i);
      const CornerResistance<double> alone = resistance(x[at], v[at]);
      EXPECT_NEAR(lane(found.worst, i), alone.worst, 1e-12);
      EXPECT_NEAR(lane(found.energy, i), alone.energy, 1e-10 * (1 + alone.energy));
      EXPECT_NEAR(lane(found.rate_square, i), alone.rate_square, 1e-10 * (1 + alone.rate_square));
      EXPECT_NEAR(lane(found.closing_rate, i), alone.closing_rate, 1e-10 * (1 + alone.closing_rate));
      for (int c = 0; c < 8; ++c) {
        EXPECT_NEAR(lane(found.force[c].y, i), alone.force[c].y, 1e-10 * (1 + forces(alone).norm()));
      }
    }
  }
}

}  // namespace
}  // namespace pinball::folding_test
