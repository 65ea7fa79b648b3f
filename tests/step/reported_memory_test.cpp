#include <gtest/gtest.h>
#include <malloc.h>

#include <functional>
#include <memory>

#include <solver/model/model_surface.hpp>
#include <tests/support/solver_case.hpp>

/// The memory that a run says it holds, against what the allocator has given out meanwhile.
namespace pinball::reported_memory_test {
namespace {

using namespace test;

double given_out() {
  const struct mallinfo2 info = ::mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

struct Case {
  const char* name;
  std::function<void(Scene&)> change;
};

class ReportedMemory : public testing::TestWithParam<Case> {};

/// Of the solver that there is, meshes and names of the scene, which are not of its stores, apart.
TEST_P(ReportedMemory, IsWhatThereIsButForTheScene) {
  Scene scene = pressed_blocks(1e-3);
  scene.bodies[0].mesh = BlockMesh{{0.6, 0.5, 0.7}, {15, 12, 9}};
  scene.bodies[1].mesh = BlockMesh{{0.4, 0.5, 0.4}, {9, 11, 6}};
  GetParam().change(scene);
  const double before = given_out();
  Solver<double> solver(scene);
  for (int step = 0; step < 6; ++step) solver.step();
  const double there = given_out() - before, said = static_cast<double>(solver.bytes());
  if (there <= 0) GTEST_SKIP() << "another allocator";
  EXPECT_LE(said, there);
  EXPECT_GT(said, 0.5 * there);
}

/// Of contact by itself, which is little beside elements; after a step.
TEST_P(ReportedMemory, OfContactIsWhatThereIs) {
  Scene scene = pressed_blocks(1e-3);
  scene.bodies[0].mesh = BlockMesh{{0.6, 0.5, 0.7}, {15, 12, 9}};
  scene.bodies[1].mesh = BlockMesh{{0.4, 0.5, 0.4}, {9, 11, 6}};
  GetParam().change(scene);
  if (scene.contact.method == ContactMethod::none) return;
  Model<double> model = build_model<double>(scene);
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {  // the bodies touch
    const std::int32_t node = model.node_of_scene_node[n];
    if (model.mesh.body_of_node[n] == 1) model.nodes.position[4 * static_cast<std::size_t>(node) + 2] -= 0.06;
  }
  const ModelSurface<double> source(model);
  constexpr double dt = 1e-6;
  const double before = given_out();
  const std::unique_ptr<ContactAlgorithm<double>> contact = make_model_contact(model);
  contact->update_surface(source, {});
  contact->search(source, dt);
  ContactWork work = contact->before_step(source, dt);
  contact->add_forces(source, work);
  contact->after_constraints(source, {dt, dt});
  EXPECT_GT(contact->listed().entries, 0);
  const double there = given_out() - before, said = static_cast<double>(contact->bytes());
  if (there <= 0) GTEST_SKIP() << "another allocator";
  EXPECT_LE(said, there);
  EXPECT_GT(said, 0.88 * there);
}

INSTANTIATE_TEST_SUITE_P(Of, ReportedMemory,
                         testing::Values(Case{"no_contact", [](Scene& s) { s.contact.method = ContactMethod::none; }},
                                         Case{"springs", [](Scene&) {}},
                                         Case{"balls", [](Scene& s) { s.contact.enforcement = Enforcement::lagrange; }},
                                         Case{"faces",
                                              [](Scene& s) {
                                                s.contact.enforcement = Enforcement::lagrange;
                                                s.contact.gap = ContactGap::face;
                                              }},
                                         Case{"slideline",
                                              [](Scene& s) { s.contact.method = ContactMethod::slideline; }},
                                         Case{"slideline_impulses",
                                              [](Scene& s) {
                                                s.contact.method = ContactMethod::slideline;
                                                s.contact.enforcement = Enforcement::projection;
                                              }},
                                         Case{"subcycling", [](Scene& s) { s.time.subcycling = true; }}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace pinball::reported_memory_test
