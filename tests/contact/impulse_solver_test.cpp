#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/base/error.hpp>
#include <solver/contact/impulses/impulse_solver.hpp>

/// Impulses of two nodes that touch, or of a few, through the solver of impulses, against what can be worked out by
/// hand.
namespace pinball::impulse_solver_test {
namespace {

Vec3<double> unit(const Vec3<double>& v) { return (1 / std::sqrt(dot(v, v))) * v; }

/// Nodes that are all there is.
class Nodes final : public SurfaceSource<double> {
 public:
  explicit Nodes(const std::vector<double>& masses)
      : mass(masses), x_(4 * masses.size()), v_(4 * masses.size()), f_(4 * masses.size()), inverse_(masses.size()) {
    position = x_.data();
    velocity = v_.data();
    force = f_.data();
    inverse_mass = inverse_.data();
    node_count = static_cast<std::int32_t>(masses.size());
    for (std::size_t n = 0; n < masses.size(); ++n) inverse_[n] = 1 / masses[n];
  }
  bool is_element(std::int64_t /*slot*/) const override { return false; }
  ContactElement element(std::int64_t /*slot*/) const override { return {}; }
  bool may_soon_erode(std::int64_t /*slot*/) const override { return false; }

  void set_velocity(std::int32_t node, const Vec3<double>& v) {
    double* const place = record(v_.data(), node);
    place[0] = v.x;
    place[1] = v.y;
    place[2] = v.z;
  }
  /// Something else than contact.
  void push(std::int32_t node, double load) { record(f_.data(), node)[2] += load; }
  /// Makes the step of length 1.
  void take_force(std::int32_t node) {
    for (int c = 0; c < 3; ++c) {
      record(v_.data(), node)[c] += record(f_.data(), node)[c] / mass[static_cast<std::size_t>(node)];
      record(f_.data(), node)[c] = 0;
    }
  }
  Vec3<double> velocity_of(std::int32_t node) const { return vector_of(v(node)); }
  Vec3<double> force_of(std::int32_t node) const { return vector_of(record(f_.data(), node)); }

  std::vector<double> mass;

 private:
  Array<double> x_, v_, f_, inverse_;
};

ContactSettings coupled(double friction = 0, double static_friction = 0, double decay = 0) {
  ContactSettings settings;
  settings.enforcement = Enforcement::lagrange;
  settings.friction = friction;
  settings.static_friction = static_friction;
  settings.friction_decay = decay;
  return settings;
}

/// Solves for the row of node 0 against node 1 in a step of length 1 after one as long. direction: from 1 to 0.
void solve_pair(ImpulseSolver<double>& solver, const Nodes& nodes, const Vec3<double>& direction, double depth) {
  solver.begin_rows();
  solver.add_row(0, 1, direction, depth, 1.0);
  solver.add_node(0, -1);
  solver.add_node(1, 1);
  solver.finish_rows(nodes, 1.0);
  solver.solve(nodes, {1.0, 1.0});
}

/// A node that is held along any direction moves across it alone: with the force that the solver gives, less what the
/// constraint takes of it, the gap closes and no more; also that of two balls, whose direction is longer than one.
TEST(ImpulsesOfTwoNodes, ClosesTheGapOfANodeThatIsHeldObliquely) {
  for (const Vec3<double>& normal :
       {unit({1, 1, 0}), unit({0, 1, 1}), unit({1, 0, 1}), unit({1, -1, 0}), unit({3, 2, -1}), unit({-1, 2, 5})}) {
    for (const Vec3<double>& direction :
         {unit({2, 1, 0}), unit({0, 2, 1}), unit({1, 0, 2}), unit({1, -3, 2}), 1.3 * unit({2, 3, 1})}) {
      Nodes nodes({2.0, 3.0});
      nodes.set_velocity(0, -4.0 * direction);
      const std::vector<HeldDirection> held{{1, {normal.x, normal.y, normal.z}}};
      ImpulseSolver<double> solver(coupled(), 2, {2, held});
      const double gap = 0.5;
      solve_pair(solver, nodes, direction, -gap);
      Vec3<double> change = (1 / nodes.mass[1]) * nodes.force_of(1);
      change = change - dot(change, normal) * normal;
      const Vec3<double> first = nodes.velocity_of(0) + (1 / nodes.mass[0]) * nodes.force_of(0);
      EXPECT_GT(dot(nodes.force_of(0), direction), 1.0);
      EXPECT_NEAR(dot(first - change, direction), -gap, 1e-12) << "what closes it within the step of length 1";
    }
  }
}

/// Both nodes slide all the time: what acts across the direction is mu times what acts along it, against the sliding.
/// The coefficient is that of the velocity with which they have slid.
TEST(ImpulsesOfTwoNodes, RubsWithTheCoefficientOfTheSlidingVelocity) {
  const double at_rest = 0.4, kinetic = 0.1;
  for (const auto& [across, way] : {std::pair{Vec3<double>{0, 0, 1}, Vec3<double>{1, 0, 0}},
                                    {Vec3<double>{0, 1, 0}, unit({-1, 0, 2})},
                                    {unit({1, 2, 3}), unit({3, 0, -1})},
                                    {unit({1, 2, 3}), unit({-2, 1, 0})}}) {
    for (const double sliding : {0.5, 2.0, 7.0, 40.0}) {
      for (const double decay : {0.0, 0.05, 0.3}) {
        Nodes nodes({2.0, 3.0});
        nodes.set_velocity(0, (100 + sliding) * way - 1e-2 * across);  // hardly any of the sliding is stopped
        nodes.set_velocity(1, 100.0 * way);
        ImpulseSolver<double> solver(coupled(kinetic, at_rest, decay), 2, {2, {}});
        solve_pair(solver, nodes, across, 0);
        const Vec3<double> force = nodes.force_of(0);
        const double along = dot(force, across);
        ASSERT_GT(along, 0);
        const double expected = decay > 0 ? kinetic + (at_rest - kinetic) * std::exp(-decay * sliding) : kinetic;
        EXPECT_NEAR(-dot(force, way) / along, expected, 1e-12) << "sliding at " << sliding << ", decay " << decay;
        EXPECT_NEAR(dot(force, cross(across, way)), 0, 1e-15);
      }
    }
  }
}

/// A node on a floor that another one strikes obliquely from above. Contact knows what friction at the floor takes of
/// the way of the first, where that slides and where it is held: after the floor has done its part nothing closes or
/// opens, but for the compliance of rows that share a node: some ten-thousandths.
TEST(ImpulsesOfTwoNodes, KnowTheFrictionOfAPlaneThatBoundsANode) {
  const Vec3<double> direction = unit({2, 1, -2}), up{0, 0, 1};
  const double speed = 4, down = 2.0 / 3, across = std::sqrt(5.0) / 3;
  for (const double between : {0.0, 0.2}) {
    for (const double friction : {0.0, 0.3, 1.1, 1.2, 1e30}) {
      Nodes nodes({2.0, 3.0});
      nodes.set_velocity(1, speed * direction);
      ImpulseSolver<double> solver(coupled(between, between), 2, {2, {}});
      solver.begin_rows();
      solver.add_row(0, 1, direction, 0, 1.0);
      solver.add_node(0, -1);
      solver.add_node(1, 1);
      solver.finish_rows(nodes, 1.0);
      const std::vector<NodeBound> floor{{0, 0, {0, 0, 1}, 0, 0, 0, friction, {0, 0, 0}}};
      solver.solve(nodes, {1.0, 1.0}, floor);
      const Vec3<double> force = nodes.force_of(0), along = force - force.z * up;
      ASSERT_LT(force.z, 0);
      const double size = std::sqrt(dot(along, along)), left = std::max(0.0, size + friction * force.z);
      const Vec3<double> first = (left / (size * nodes.mass[0])) * along;
      const Vec3<double> second = nodes.velocity_of(1) + (1 / nodes.mass[1]) * nodes.force_of(1);
      EXPECT_NEAR(dot(second - first, direction), 0, 1e-3 * speed) << friction << ", between the nodes " << between;
      if (between > 0) continue;
      const double slides = across * std::max(0.0, across - friction * down) / nodes.mass[0];
      const double expected = speed / (1 / nodes.mass[1] + slides);
      EXPECT_NEAR(dot(force, direction), expected, 1e-3 * expected) << friction;
    }
  }
}

/// What is deep by approach leaves by a tenth of its depth in a step, and with no more energy than it has brought.
TEST(ImpulsesOfTwoNodes, PushesADepthOutByATenthInAStep) {
  for (const double speed : {4.0, 0.5}) {
    Nodes nodes({2.0, 3.0});
    const double depth = 0.25, reduced = 2.0 * 3.0 / 5.0;
    nodes.set_velocity(0, {0, 0, -speed});
    ImpulseSolver<double> solver(coupled(), 2, {2, {}});
    solve_pair(solver, nodes, {0, 0, 1}, depth);
    // Both are stopped; no time goes by for the pair, which is as deep in the next step.
    const Vec3<double> stopped = nodes.velocity_of(0) + (1 / nodes.mass[0]) * nodes.force_of(0);
    EXPECT_NEAR(stopped.z, (1 / nodes.mass[1]) * nodes.force_of(1).z, 1e-12);
    for (const std::int32_t n : {0, 1}) nodes.take_force(n);
    solve_pair(solver, nodes, {0, 0, 1}, depth);
    const double apart = (nodes.force_of(0).z / nodes.mass[0]) - (nodes.force_of(1).z / nodes.mass[1]);
    EXPECT_NEAR(apart, 0.1 * depth, 1e-12) << "of an energy of " << 0.5 * reduced * speed * speed;
  }
}

/// Deeper by something else than approach, as where erosion has exposed a face: that is not pushed out, whatever the
/// pair has taken out before.
TEST(ImpulsesOfTwoNodes, DoNotPushOutWhatHasNotComeInByApproach) {
  Nodes nodes({2.0, 3.0});
  nodes.set_velocity(0, {0, 0, -4});
  ImpulseSolver<double> solver(coupled(), 2, {2, {}});
  for (const double depth : {-0.5, 0.0, 0.0}) {  // stopped in two steps, and what the last one releases
    solve_pair(solver, nodes, {0, 0, 1}, depth);
    EXPECT_GT(nodes.force_of(0).z, 0.1);
    for (const std::int32_t n : {0, 1}) nodes.take_force(n);
  }
  nodes.set_velocity(0, nodes.velocity_of(1));
  solve_pair(solver, nodes, {0, 0, 1}, 0.25);
  EXPECT_NEAR(nodes.force_of(0).z, 0, 1e-12);
}

/// The change of the one that is easier to move, of what closes within two steps.
TEST(ImpulsesOfTwoNodes, ExpectTheChangeOfTheLighterOne) {
  const auto expected = [](const Vec3<double>& direction, double speed, double depth, std::vector<HeldDirection> held) {
    Nodes nodes({2.0, 3.0});
    nodes.set_velocity(0, -speed * direction);
    ImpulseSolver<double> solver(coupled(), 2, {2, std::move(held)});
    solver.begin_rows();
    solver.add_row(0, 1, direction, depth, 1.0);
    solver.add_node(0, -1);
    solver.add_node(1, 1);
    solver.finish_rows(nodes, 1.0);
    return solver.expected_change(nodes, 1.0);
  };
  const double share = (1 / 2.0) / (1 / 2.0 + 1 / 3.0);
  for (const Vec3<double>& direction : {Vec3<double>{1, 0, 0}, Vec3<double>{0, 0, -1}, unit({1, -2, 3})}) {
    EXPECT_NEAR(expected(direction, 4, 0, {}), 4 * share, 1e-12);
    EXPECT_NEAR(expected(direction, 4, -7.9, {}), 4 * share, 1e-12);
    EXPECT_EQ(expected(direction, 4, -8.1, {}), 0) << "closes later";
    EXPECT_EQ(expected(direction, -4, 0, {}), 0) << "opens";
    EXPECT_NEAR(expected(direction, 4, 0, {{1, {1, 0, 0}}, {1, {0, 1, 0}}, {1, {0, 0, 1}}}), 4, 1e-12)
        << "all is the other's, where one is held";
  }
  EXPECT_EQ(expected({1, 0, 0}, 4, 0, {{0, {1, 0, 0}}, {1, {1, 0, 0}}}), 0) << "both are held";
  // Of the mobilities 1/2 and (1 - 0.6^2) / 3 along the direction.
  EXPECT_NEAR(expected({0.6, 0, 0.8}, 4, 0, {{1, {1, 0, 0}}}), 4 * 0.5 / (0.5 + 0.64 / 3), 1e-12);
}

/// Numbers of a row's nodes that are none of the nodes that there are.
TEST(ImpulsesOfTwoNodes, AreNotReadWithNodesThatAreNone) {
  Nodes nodes({1, 1, 1, 1, 1, 1, 1, 1, 2, 3});
  nodes.set_velocity(7, {0, 0, -4});
  ImpulseSolver<double> solver(coupled(), 10, {10, {}});
  solver.begin_rows();
  solver.add_row(7, 9, {0, 0, 1}, 0, 1.0);
  solver.add_node(7, -1);
  solver.add_node(9, 1);
  solver.finish_rows(nodes, 1.0);
  solver.solve(nodes, {1.0, 1.0});
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { solver.persist(archive, nodes); });
  const auto read = [&] {
    StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
    ImpulseSolver<double>(coupled(), 10, {10, {}}).persist(archive, nodes);
  };
  EXPECT_NO_THROW(read());
  const std::int32_t places[2] = {0, 1};  // of the nodes of the row, in the list 7, 9
  int found = 0;
  for (std::size_t at = 0; at + sizeof places <= bytes.size(); at += sizeof places[0]) {
    std::uint64_t count = 0;
    if (at >= sizeof count) std::memcpy(&count, bytes.data() + at - sizeof count, sizeof count);
    if (count != 2 || std::memcmp(bytes.data() + at, places, sizeof places) != 0) continue;
    ++found;
    for (const std::int32_t none : {2, -1}) {
      std::memcpy(bytes.data() + at + sizeof none, &none, sizeof none);
      EXPECT_THROW(read(), InputError) << none;
    }
    std::memcpy(bytes.data() + at, places, sizeof places);
  }
  EXPECT_EQ(found, 1);
}

/// Nodes close a gap to one that they have in common, are stopped, pressed on without moving, and let go. In the step
/// after the last that pushes each gets half of that once more, but together with no more energy than they were stopped
/// with in both steps.
TEST(ImpulsesOfTwoNodes, GiveBackNoMoreThanTheyHaveTaken) {
  constexpr double opening = 0.1;
  struct Case {
    std::int32_t count;
    bool common_first;  // in the rows
    double pressing, speed;
  };
  std::vector<Case> cases;
  for (const double pressing : {20.0, 1.5}) {
    for (const double speed : {1.0, 0.3}) {
      for (const std::int32_t count : {1, 3}) {
        for (const bool first : {false, true}) cases.push_back({count, first, pressing, speed});
      }
    }
  }
  for (const auto& [count, common_first, pressing, speed] : cases) {
    const double bound = count == 1 ? 1e-12 : 1e-9;      // of several that hang together to what their solution is
    const double reduced = 1 / (1 / 2.0 + count / 3.0);  // of each, where all do the same
    std::vector<double> masses(static_cast<std::size_t>(count), 2.0);
    masses.push_back(3.0);
    Nodes nodes(masses);
    for (std::int32_t n = 0; n < count; ++n) nodes.set_velocity(n, {0, 0, -speed});
    ImpulseSolver<double> solver(coupled(), count + 1, {count + 1, {}});
    const auto step = [&](double load, double depth) {  // returns the impulse of each
      solver.begin_rows();
      for (std::int32_t n = 0; n < count; ++n) {
        nodes.push(n, load);
        solver.add_row(n, 10 + n, {0, 0, 1}, depth, 1.0);
        if (common_first) solver.add_node(count, 1);
        solver.add_node(n, -1);
        if (!common_first) solver.add_node(count, 1);
      }
      solver.finish_rows(nodes, 1.0);
      solver.solve(nodes, {1.0, 1.0});
      const double impulse = nodes.force_of(0).z - load;
      for (std::int32_t n = 0; n < count; ++n) EXPECT_NEAR(nodes.force_of(n).z - load, impulse, bound);
      for (std::int32_t n = 0; n <= count; ++n) nodes.take_force(n);
      return impulse;
    };
    EXPECT_NEAR(step(0, -0.5 * speed), 0.5 * reduced * speed, bound);
    EXPECT_NEAR(step(0, 0), 0.5 * reduced * speed, bound);
    const double last = step(-pressing, 0);
    EXPECT_NEAR(last, pressing * reduced / 2.0, bound);
    // p (0 + opening + p / reduced) / 2 <= reduced speed^2 / 2, for all were at rest in the step before
    const double half = 0.5 * reduced * opening;
    const double most = -half + std::sqrt(half * half + reduced * reduced * speed * speed);
    EXPECT_NEAR(step(2.0 * opening, 0), std::min(0.5 * last, most), bound)
        << count << ", " << common_first << ", " << pressing << ", " << speed;
  }
}

/// Held directions of unit length add up to what leaves no mobility but that of rounding, which is none: the same as
/// along the axes, where it is zero. Also of nodes that move across the row alone.
TEST(ImpulsesOfTwoNodes, DoNothingWhereBothAreHeldAlongTheRow) {
  for (const double friction : {0.0, 0.3}) {
    for (const auto& [x, y] : {std::pair{unit({1, 2, 3}), unit({3, 0, -1})},
                               {unit({-0.3, 0.1, 0.7}), unit({0.7, 0.7, 0.2})},
                               {unit({5, -1, 2}), unit({1, 9, 2})}}) {
      const Vec3<double> z = unit(cross(x, y)), across = unit(cross(z, x)), row = unit(0.6 * x + 0.8 * z);
      for (const bool entirely : {false, true}) {
        std::vector<HeldDirection> held;
        for (const std::int32_t node : {0, 1}) {
          held.push_back({node, {x.x, x.y, x.z}});
          held.push_back({node, {z.x, z.y, z.z}});
          if (entirely) held.push_back({node, {across.x, across.y, across.z}});
        }
        Nodes nodes({2.0, 3.0});
        nodes.set_velocity(0, -4.0 * row);
        ImpulseSolver<double> solver(coupled(friction, friction), 2, {2, held});
        solve_pair(solver, nodes, row, 0);
        EXPECT_EQ(dot(nodes.force_of(0), nodes.force_of(0)), 0) << entirely << ' ' << friction;
      }
    }
  }
}

/// Three rows, each as if it were alone.
TEST(ImpulsesOfTwoNodes, DoNotDependOnRowsThatShareNoNode) {
  Nodes nodes({1, 2, 3, 4, 5, 6});
  const Vec3<double> a[3] = {unit({1, 2, 3}), unit({-1, 0, 1}), unit({0, 1, 0})};
  ImpulseSolver<double> solver(coupled(), 6, {6, {}});
  solver.begin_rows();
  for (std::int32_t i = 0; i < 3; ++i) {
    nodes.set_velocity(2 * i, -(1.0 + i) * a[i]);
    solver.add_row(i, 10 + i, a[i], -0.1, 1.0);
    solver.add_node(2 * i, -1);
    solver.add_node(2 * i + 1, 1);
  }
  solver.finish_rows(nodes, 1.0);
  EXPECT_EQ(solver.solve(nodes, {1.0, 1.0}).pairs, 3);
  for (std::int32_t i = 0; i < 3; ++i) {
    const std::size_t one = 2 * static_cast<std::size_t>(i);
    const double impulse = (1.0 + i - 0.1) / (1 / nodes.mass[one] + 1 / nodes.mass[one + 1]);
    for (const auto& [node, sign] : {std::pair{2 * i, 1.0}, std::pair{2 * i + 1, -1.0}}) {
      const Vec3<double> off = nodes.force_of(node) - sign * impulse * a[i];
      EXPECT_LT(std::sqrt(dot(off, off)), 1e-12 * impulse) << node;
    }
  }
}

}  // namespace
}  // namespace pinball::impulse_solver_test
