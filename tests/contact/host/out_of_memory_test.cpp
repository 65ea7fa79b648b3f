#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include <solver/contact/contact.h>
#include <tests/support/failing_memory.hpp>

/// Memory that runs out anywhere: a status, never the end of the host, and nothing is left behind.
namespace pinball::out_of_memory_test {
namespace {

using test::Memory;

/// Two blocks of cubes, which overlap a little and approach.
struct Blocks {
  static constexpr int n = 6;
  std::vector<double> position, velocity, force, mass;
  std::vector<std::int32_t> corners, body;
  std::vector<double> bulk_modulus;
  pinball_contact_options options;
  pinball_contact_mesh mesh;
  pinball_contact_arrays arrays;

  explicit Blocks(std::int32_t method, std::int32_t enforcement) {
    for (int b = 0; b < 2; ++b) add_block(b);
    force.assign(position.size(), 0.0);
    mass.assign(position.size() / 3, 1.0);
    pinball_contact_options_init(&options);
    options.method = method;
    options.enforcement = enforcement;
    options.threads = 3;
    pinball_contact_mesh_init(&mesh);
    mesh.node_count = static_cast<std::int64_t>(mass.size());
    mesh.mass = mass.data();
    mesh.element_count = static_cast<std::int64_t>(body.size());
    mesh.corners = corners.data();
    mesh.body = body.data();
    bulk_modulus.assign(body.size(), 1e4);
    mesh.bulk_modulus = bulk_modulus.data();
    pinball_contact_arrays_init(&arrays);
    arrays.position = {position.data(), position.data() + 1, position.data() + 2, 3};
    arrays.velocity = {velocity.data(), velocity.data() + 1, velocity.data() + 2, 3};
    arrays.force = {force.data(), force.data() + 1, force.data() + 2, 3};
  }

  void add_block(int b) {
    const auto first = static_cast<std::int32_t>(position.size() / 3);
    const auto node = [&](int i, int j, int k) { return first + (k * (n + 1) + j) * (n + 1) + i; };
    for (int k = 0; k <= 2; ++k) {
      for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
          position.insert(position.end(), {i + 0.3 * b, j + 0.2 * b, k + 1.99 * b});
          velocity.insert(velocity.end(), {0, 0, -1000.0 * b});
        }
      }
    }
    for (int k = 0; k < 2; ++k) {
      for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
          for (const int up : {k, k + 1}) {
            corners.insert(corners.end(),
                           {node(i, j, up), node(i + 1, j, up), node(i + 1, j + 1, up), node(i, j + 1, up)});
          }
          body.push_back(b);
        }
      }
    }
  }
};

/// A whole life of two steps, ended by the first status that is not OK.
int live(Blocks& blocks) {
  const pinball_contact_input start = blocks.arrays.position;
  pinball_contact* contact = nullptr;
  int status = pinball_contact_create(&blocks.options, &blocks.mesh, &start, &contact);
  pinball_contact_result result{};
  for (int step = 0; step < 2 && status == PINBALL_CONTACT_OK; ++step) {
    status = pinball_contact_update(contact, &blocks.arrays, step == 0 ? 0 : 1e-4);
    if (status == PINBALL_CONTACT_OK) status = pinball_contact_add_forces(contact, &blocks.arrays, 1e-4, &result);
  }
  if (status != PINBALL_CONTACT_OK && contact != nullptr) {
    EXPECT_STREQ(pinball_contact_message(contact), "out of memory");
    EXPECT_NE(pinball_contact_update(contact, &blocks.arrays, 0), PINBALL_CONTACT_OK);
  }
  pinball_contact_destroy(contact);
  return status;
}

void expect_no_harm(std::int32_t method, std::int32_t enforcement) {
  Blocks first(method, enforcement);
  ASSERT_EQ(live(first), PINBALL_CONTACT_OK);  // the threads are there now
  EXPECT_NE(first.force, std::vector<double>(first.force.size(), 0.0)) << "they touch";
  int refused = 0;
  Blocks blocks(method, enforcement);
  const std::int64_t with_blocks = Memory::alive;
  const std::int64_t requests = Memory::refuse_each([&] {
    const int status = live(blocks);
    if (status != PINBALL_CONTACT_OK) {
      EXPECT_EQ(status, PINBALL_CONTACT_OUT_OF_MEMORY);
      ++refused;
    }
    EXPECT_EQ(Memory::alive, with_blocks) << "left behind";
  });
  EXPECT_GT(requests, 100);
  EXPECT_GT(refused, 100);
}

TEST(OutOfMemory, PenaltyOfPinballs) { expect_no_harm(PINBALL_CONTACT_PINBALL, PINBALL_CONTACT_PENALTY); }
TEST(OutOfMemory, ImpulsesBetweenFaces) { expect_no_harm(PINBALL_CONTACT_PINBALL, PINBALL_CONTACT_LAGRANGE); }
TEST(OutOfMemory, PenaltyOfTheSlideline) { expect_no_harm(PINBALL_CONTACT_SLIDELINE, PINBALL_CONTACT_PENALTY); }
TEST(OutOfMemory, ImpulsesOfTheSlideline) { expect_no_harm(PINBALL_CONTACT_SLIDELINE, PINBALL_CONTACT_PROJECTION); }

}  // namespace
}  // namespace pinball::out_of_memory_test
