#include <gtest/gtest.h>

#include <string>

#include <solver/step/places.hpp>
#include <tests/support/solver_case.hpp>

/// Where something is worst: every number that it may be found by, each element in turn.
namespace pinball::places_test {
namespace {

using namespace test;

/// Bodies of one element.
Scene cubes(std::size_t count, HourglassControl control) {
  Scene scene = scene_of({}, 1e-3, false);
  for (std::size_t b = 0; b < count; ++b) {
    scene.bodies.push_back(block("body" + std::to_string(b), {1, 1, 1}, 1, {2.0 * static_cast<double>(b), 0, 0}));
  }
  scene.element.hourglass = control;
  return scene;
}

/// Values of the modes eta zeta, zeta xi, xi eta and xi eta zeta at a corner of the element.
double mode_at(int mode, std::size_t corner) {
  const double xi = corner % 4 == 1 || corner % 4 == 2 ? 1 : -1, eta = corner % 4 >= 2 ? 1 : -1,
               zeta = corner >= 4 ? 1 : -1;
  return mode == 0 ? eta * zeta : mode == 1 ? zeta * xi : mode == 2 ? xi * eta : xi * eta * zeta;
}

TEST(Places, EveryMovingHourglassModeOfAnyElementIsSeen) {
  const Scene scene = cubes(3, HourglassControl::viscous);
  for (int mode = 0; mode < 4; ++mode) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t most = 0; most < 3; ++most) {
        Model<double> model = build_model<double>(scene);
        for (std::size_t e = 0; e < 3; ++e) {
          for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::int32_t node = model.node_of_scene_node[model.mesh.hexahedra[e][corner]];
            double* const v = &model.nodes.velocity[4 * static_cast<std::size_t>(node)];
            v[k] = (e == most ? 1.0 : 0.5) * mode_at(mode, corner);
            v[(k + 1) % 3] = 100 * (corner % 4 == 1 || corner % 4 == 2 ? 1 : -1);  // a strain is none
          }
        }
        EXPECT_EQ(most_hourglassed_slot(model), model.slot_of_element[most]) << mode << ' ' << k;
      }
    }
  }
  EXPECT_EQ(most_hourglassed_slot(build_model<double>(scene)), -1) << "nothing moves";
}

TEST(Places, EveryKeptHourglassForceOfAnyElementIsSeen) {
  const Scene scene = cubes(3, HourglassControl::stiffness);
  for (int component = 0; component < 12; ++component) {
    for (std::size_t most = 0; most < 3; ++most) {
      Model<double> model = build_model<double>(scene);
      for (std::size_t e = 0; e < 3; ++e) {
        model.elements.hourglass_state[model.elements.at(model.slot_of_element[e], component, 12)] =
            e == most ? -1.0 : 0.5;
      }
      EXPECT_EQ(most_hourglassed_slot(model), model.slot_of_element[most]) << component;
      model.elements.mass[static_cast<std::size_t>(model.slot_of_element[most])] = 0;
      EXPECT_NE(most_hourglassed_slot(model), model.slot_of_element[most]) << "eroded";
    }
  }
}

/// Whatever they do: of the three bodies one alone has elements with hourglass forces.
TEST(Places, ElementsWithoutHourglassForcesAreNoneOfThem) {
  for (const HourglassControl control : {HourglassControl::viscous, HourglassControl::assumed_strain}) {
    Scene scene = cubes(4, control);
    scene.bodies[0].elements = ElementShape::tetrahedra;
    scene.bodies[1].element = scene.element;
    scene.bodies[1].element->hourglass = HourglassControl::none;
    scene.rigid_bodies.emplace_back().bodies = {"body2"};
    Model<double> model = build_model<double>(scene);
    for (std::size_t i = 0; i < model.nodes.velocity.size(); ++i) model.nodes.velocity[i] = (i * i * i) % 7;
    for (std::size_t i = 0; i < model.elements.hourglass_state.size(); ++i) {
      model.elements.hourglass_state[static_cast<std::int64_t>(i)] = static_cast<double>((i * i * i) % 5);
    }
    const std::int64_t last = model.slot_of_element.back();
    EXPECT_EQ(most_hourglassed_slot(model), last);
  }
}

/// Of the same stress a soft element has more energy.
TEST(Places, KeptHourglassForcesCountByTheirEnergy) {
  Scene scene = cubes(2, HourglassControl::stiffness);
  Material& soft = scene.materials.emplace_back(elastic_material("soft"));
  soft.bulk_modulus /= 1000;
  soft.shear_modulus /= 1000;
  scene.bodies[1].material = "soft";
  Model<double> model = build_model<double>(scene);
  for (const std::size_t e : {0, 1}) {
    model.elements.hourglass_state[model.elements.at(model.slot_of_element[e], 0, 12)] = e == 0 ? 1.0 : 0.5;
  }
  EXPECT_EQ(most_hourglassed_slot(model), model.slot_of_element[1]);
}

/// A turn is none of the hourglass modes of an element, whatever its shape.
TEST(Places, ATurningElementMovesNoHourglassModes) {
  Scene scene = cubes(2, HourglassControl::viscous);
  Model<double> model = build_model<double>(scene);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const std::int32_t turning = model.node_of_scene_node[model.mesh.hexahedra[0][corner]],
                       bent = model.node_of_scene_node[model.mesh.hexahedra[1][corner]];
    double *const x = &model.nodes.position[4 * turning], *const v = &model.nodes.velocity[4 * turning];
    x[0] *= 1 + 0.3 * x[1] + 0.2 * x[1] * x[2];
    v[0] = -100 * x[1];
    v[1] = 100 * x[0];
    model.nodes.velocity[4 * bent] = 0.01 * mode_at(0, corner);
  }
  EXPECT_EQ(most_hourglassed_slot(model), model.slot_of_element[1]);
}

TEST(Places, AnyNodeHasItsName) {
  const Model<double> model = build_model<double>(cubes(2, HourglassControl::none));
  for (std::size_t n = 0; n < 16; ++n) {
    EXPECT_EQ(node_name(model, model.node_of_scene_node[n]),
              "node " + std::to_string(n) + " of body body" + std::to_string(n / 8));
  }
  EXPECT_EQ(node_name(model, -1), "");
}

TEST(Places, CornersAtTheForcesAreAStepBack) {
  Scene scene = cubes(1, HourglassControl::none);
  scene.bodies[0].velocity = {1, 2, 4};
  const Model<double> model = build_model<double>(scene);
  const std::array<Point, 8> corners = corners_at_forces(model, model.slot_of_element[0], 0.5);
  for (std::size_t i = 0; i < 8; ++i) {
    const Point& x = model.mesh.nodes[static_cast<std::size_t>(model.mesh.hexahedra[0][i])];
    for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(corners[i][k], x[k] - 0.5 * scene.bodies[0].velocity[k]);
  }
}

}  // namespace
}  // namespace pinball::places_test
