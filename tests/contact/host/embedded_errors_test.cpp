#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <solver/contact/contact.h>

/// What a host passes wrongly: a status, a message that names the argument, and nothing else.
namespace pinball::embedded_errors_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Two cubes that meet within the step, and whose balls overlap a little; a sphere above them, and one held node.
struct Case {
  std::vector<double> position, velocity = std::vector<double>(51, 0.25), force = std::vector<double>(51, 7.0),
                                mass = std::vector<double>(17, 2.0);
  std::vector<std::int32_t> corners, body{0, 1}, part{0, 0}, sphere_node{16}, held_node{3};
  std::vector<double> bulk_modulus{1e4, 1e4}, sphere_radius{0.3}, sphere_modulus{1e4}, held_direction{0, 0, 1};
  std::vector<double> element_mass{8, 8}, element_volume{1, 1};
  std::vector<std::int64_t> tiles{0, 2};
  std::vector<std::uint8_t> alive{1, 1};
  pinball_contact_options options;
  pinball_contact_mesh mesh;
  pinball_contact_input start;
  pinball_contact_arrays arrays;
  double dt_before = 1e-4, dt_after = 1e-4;

  Case() {
    const int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int e = 0; e < 2; ++e) {
      for (int i = 0; i < 8; ++i) {
        corners.push_back(8 * e + i);
        for (int k = 0; k < 3; ++k) position.push_back(corner[i][k] + (k == 2 ? 1.2 * e : 0.0));
      }
    }
    position.insert(position.end(), {0.5, 0.5, 5});
    for (std::size_t node = 8; node < 16; ++node) velocity[3 * node + 2] = -3000;
    pinball_contact_options_init(&options);
    pinball_contact_mesh_init(&mesh);
    pinball_contact_arrays_init(&arrays);
    mesh.node_count = 17;
    mesh.mass = mass.data();
    mesh.element_count = 2;
    mesh.corners = corners.data();
    mesh.body = body.data();
    mesh.bulk_modulus = bulk_modulus.data();
    mesh.part = part.data();
    mesh.part_count = 2;
    mesh.element_mass = element_mass.data();
    mesh.element_volume = element_volume.data();
    mesh.sphere_count = 1;
    mesh.sphere_node = sphere_node.data();
    mesh.sphere_radius = sphere_radius.data();
    mesh.sphere_bulk_modulus = sphere_modulus.data();
    mesh.held_count = 1;
    mesh.held_node = held_node.data();
    mesh.held_direction = held_direction.data();
    mesh.tile_offsets = tiles.data();
    mesh.tile_count = 1;
    start = {position.data(), position.data() + 1, position.data() + 2, 3};
    arrays.position = start;
    arrays.velocity = {velocity.data(), velocity.data() + 1, velocity.data() + 2, 3};
    arrays.force = {force.data(), force.data() + 1, force.data() + 2, 3};
    arrays.alive = alive.data();
  }
};

struct Wrong {
  const char* what;
  std::function<void(Case&)> change;
  int status;
  const char* named;  ///< in the message
};

void expect_message(const pinball_contact* contact, const Wrong& wrong) {
  EXPECT_NE(std::string(pinball_contact_message(contact)).find(wrong.named), std::string::npos)
      << wrong.what << ": " << pinball_contact_message(contact);
}

TEST(EmbeddedErrors, OfCreationNameTheArgument) {
  const std::vector<Wrong> all = {
      {"size of options", [](Case& c) { c.options.size -= 8; }, PINBALL_CONTACT_BAD_VERSION, "options->size"},
      {"size of mesh", [](Case& c) { c.mesh.size = 0; }, PINBALL_CONTACT_BAD_VERSION, "mesh->size"},
      {"number", [](Case& c) { c.options.number = 2; }, PINBALL_CONTACT_BAD_OPTION, "options->number"},
      {"index", [](Case& c) { c.options.index = -1; }, PINBALL_CONTACT_BAD_OPTION, "options->index"},
      {"first", [](Case& c) { c.options.first_index = 2; }, PINBALL_CONTACT_BAD_OPTION, "options->first_index"},
      {"method", [](Case& c) { c.options.method = 7; }, PINBALL_CONTACT_BAD_OPTION, "options->method"},
      {"spheres", [](Case& c) { c.options.method = 1; }, PINBALL_CONTACT_BAD_OPTION, "options->method"},
      {"enforcement", [](Case& c) { c.options.enforcement = 3; }, PINBALL_CONTACT_BAD_OPTION, "options->enforcement"},
      {"gap", [](Case& c) { c.options.gap = 2; }, PINBALL_CONTACT_BAD_OPTION, "options->gap"},
      {"radius", [](Case& c) { c.options.radius = 2; }, PINBALL_CONTACT_BAD_OPTION, "options->radius"},
      {"radii of spheres", [](Case& c) { c.options.radius = 1; }, PINBALL_CONTACT_BAD_OPTION, "options->radius"},
      {"self", [](Case& c) { c.options.self = 2; }, PINBALL_CONTACT_BAD_OPTION, "options->self"},
      {"lists", [](Case& c) { c.options.keep_lists = -1; }, PINBALL_CONTACT_BAD_OPTION, "options->keep_lists"},
      {"threads", [](Case& c) { c.options.threads = -1; }, PINBALL_CONTACT_BAD_OPTION, "options->threads"},
      {"too many threads", [](Case& c) { c.options.threads = 4097; }, PINBALL_CONTACT_BAD_OPTION, "options->threads"},
      {"beta", [](Case& c) { c.options.beta = 0; }, PINBALL_CONTACT_BAD_OPTION, "options->beta"},
      {"damping", [](Case& c) { c.options.damping = nan; }, PINBALL_CONTACT_BAD_OPTION, "options->damping"},
      {"friction", [](Case& c) { c.options.friction = -1; }, PINBALL_CONTACT_BAD_OPTION, "options->friction"},
      {"springs rub", [](Case& c) { c.options.friction = 0.1; }, PINBALL_CONTACT_BAD_OPTION, "options->friction"},
      {"at rest less", [](Case& c) { c.options.friction = 0.2, c.options.static_friction = 0.1; },
       PINBALL_CONTACT_BAD_OPTION, "options->static_friction"},
      {"factor", [](Case& c) { c.options.radius_factor = -1; }, PINBALL_CONTACT_BAD_OPTION, "options->radius_factor"},
      {"skin", [](Case& c) { c.options.skin = infinite; }, PINBALL_CONTACT_BAD_OPTION, "options->skin"},
      {"nodes", [](Case& c) { c.mesh.node_count = 0; }, PINBALL_CONTACT_BAD_COUNT, "mesh->node_count"},
      {"elements", [](Case& c) { c.mesh.element_count = -2; }, PINBALL_CONTACT_BAD_COUNT, "mesh->element_count"},
      {"spheres", [](Case& c) { c.mesh.sphere_count = -1; }, PINBALL_CONTACT_BAD_COUNT, "mesh->sphere_count"},
      {"nothing", [](Case& c) { c.mesh.element_count = c.mesh.sphere_count = 0; }, PINBALL_CONTACT_BAD_COUNT,
       "mesh->element_count + mesh->sphere_count"},
      {"too many", [](Case& c) { c.mesh.node_count = std::int64_t{1} << 40; }, PINBALL_CONTACT_BAD_COUNT,
       "mesh->node_count"},
      {"no mass", [](Case& c) { c.mesh.mass = nullptr; }, PINBALL_CONTACT_NULL_POINTER, "mesh->mass"},
      {"negative mass", [](Case& c) { c.mass[5] = -2; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->mass[5]"},
      {"zero mass", [](Case& c) { c.mass[16] = 0; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->mass[16]"},
      {"mass", [](Case& c) { c.mass[0] = nan; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->mass[0]"},
      {"no corners", [](Case& c) { c.mesh.corners = nullptr; }, PINBALL_CONTACT_NULL_POINTER, "mesh->corners"},
      {"corner", [](Case& c) { c.corners[11] = 17; }, PINBALL_CONTACT_BAD_INDEX, "mesh->corners[11]"},
      {"corner below", [](Case& c) { c.corners[2] = -1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->corners[2]"},
      {"first corner", [](Case& c) { c.corners[0] = -1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->corners[0]"},
      {"from 1", [](Case& c) { c.options.first_index = 1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->corners[0]"},
      {"body", [](Case& c) { c.body[1] = -1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->body[1]"},
      {"first body", [](Case& c) { c.body[0] = -1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->body[0]"},
      {"part", [](Case& c) { c.part[1] = 2; }, PINBALL_CONTACT_BAD_INDEX, "mesh->part[1]"},
      {"first part", [](Case& c) { c.part[0] = -1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->part[0]"},
      {"no modulus", [](Case& c) { c.mesh.bulk_modulus = nullptr; }, PINBALL_CONTACT_NULL_POINTER,
       "mesh->bulk_modulus"},
      {"modulus", [](Case& c) { c.bulk_modulus[1] = 0; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->bulk_modulus[1]"},
      {"first modulus", [](Case& c) { c.bulk_modulus[0] = nan; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->bulk_modulus[0]"},
      {"element mass", [](Case& c) { c.element_mass[1] = -8; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->element_mass[1]"},
      {"volume", [](Case& c) { c.element_volume[0] = 0; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->element_volume[0]"},
      {"inside out",
       [](Case& c) {
         c.mesh.element_volume = nullptr, std::swap_ranges(&c.corners[8], &c.corners[12], &c.corners[12]);
       },
       PINBALL_CONTACT_BAD_NUMBER, "element 1 of mesh->corners"},
      {"two equal faces", [](Case& c) { std::copy_n(c.corners.begin(), 4, c.corners.begin() + 4); },
       PINBALL_CONTACT_BAD_MESH, "element 0 has two faces"},
      {"sphere's node", [](Case& c) { c.sphere_node[0] = 99; }, PINBALL_CONTACT_BAD_INDEX, "mesh->sphere_node[0]"},
      {"no radius", [](Case& c) { c.mesh.sphere_radius = nullptr; }, PINBALL_CONTACT_NULL_POINTER,
       "mesh->sphere_radius"},
      {"radius", [](Case& c) { c.sphere_radius[0] = -0.3; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->sphere_radius[0]"},
      {"held", [](Case& c) { c.held_node[0] = 17; }, PINBALL_CONTACT_BAD_INDEX, "mesh->held_node[0]"},
      {"direction", [](Case& c) { c.held_direction[2] = 2; }, PINBALL_CONTACT_BAD_NUMBER, "mesh->held_direction"},
      {"direction of no length", [](Case& c) { c.held_direction[2] = 0; }, PINBALL_CONTACT_BAD_NUMBER, "entry 0"},
      {"direction along x", [](Case& c) { c.held_direction[0] = 0.5; }, PINBALL_CONTACT_BAD_NUMBER, "entry 0"},
      {"direction along y", [](Case& c) { c.held_direction[1] = 0.5; }, PINBALL_CONTACT_BAD_NUMBER, "entry 0"},
      {"two directions",
       [](Case& c) {
         c.held_node = {3, 2, 3}, c.held_direction = {0, 0, 1, 0, 0, 1, 0, 0.6, 0.8};
         c.mesh.held_count = 3, c.mesh.held_node = c.held_node.data(), c.mesh.held_direction = c.held_direction.data();
       },
       PINBALL_CONTACT_BAD_NUMBER, "mesh->held_direction: entries 0 and 2 are of one node and not orthogonal"},
      {"the same element twice", [](Case& c) { std::copy_n(c.corners.begin(), 8, c.corners.begin() + 8); },
       PINBALL_CONTACT_BAD_MESH, "elements 0 and 1 have the same nodes"},
      {"far stride", [](Case& c) { c.start.stride = std::int64_t{1} << 58; }, PINBALL_CONTACT_BAD_COUNT,
       "position->stride"},
      {"far away", [](Case& c) { c.position[3 * 7 + 1] = 1e300; }, PINBALL_CONTACT_BAD_NUMBER, "position: node 7"},
      {"large",
       [](Case& c) {
         for (double& x : c.position) x *= 1e120;
         c.mesh.element_volume = nullptr;
       },
       PINBALL_CONTACT_BAD_NUMBER, "position: element 0 of mesh->corners has no volume > 0: inf"},
      {"most threads", [](Case& c) { c.options.threads = std::numeric_limits<std::int32_t>::max(); },
       PINBALL_CONTACT_BAD_OPTION, "options->threads"},
      {"tiles", [](Case& c) { c.tiles[1] = 1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->tile_offsets[1]"},
      {"first tile", [](Case& c) { c.tiles[0] = 1; }, PINBALL_CONTACT_BAD_INDEX, "mesh->tile_offsets[0]"},
      {"no place", [](Case& c) { c.start.y = nullptr; }, PINBALL_CONTACT_NULL_POINTER, "position"},
      {"stride", [](Case& c) { c.start.stride = 0; }, PINBALL_CONTACT_BAD_COUNT, "position->stride"},
      {"place", [](Case& c) { c.position[3 * 7 + 1] = nan; }, PINBALL_CONTACT_BAD_NUMBER, "position: node 7"},
  };
  for (const Wrong& wrong : all) {
    Case c;
    wrong.change(c);
    pinball_contact* contact = nullptr;
    EXPECT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, &contact), wrong.status) << wrong.what;
    ASSERT_NE(contact, nullptr);
    expect_message(contact, wrong);
    EXPECT_EQ(pinball_contact_update(contact, &c.arrays, 0), PINBALL_CONTACT_BAD_ORDER);
    pinball_contact_destroy(contact);
  }
}

/// Along each axis and between them, of one node and of others.
TEST(EmbeddedErrors, HeldDirectionsOfUnitLengthAreTaken) {
  Case c;
  c.held_node = {3, 3, 3, 9, 10};
  c.held_direction = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.6, 0, 0.8, 0, -0.8, 0.6};
  c.mesh.held_count = 5;
  c.mesh.held_node = c.held_node.data();
  c.mesh.held_direction = c.held_direction.data();
  pinball_contact* contact = nullptr;
  EXPECT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, &contact), PINBALL_CONTACT_OK)
      << pinball_contact_message(contact);
  pinball_contact_destroy(contact);
}

TEST(EmbeddedErrors, NullPointersAreNamed) {
  Case c;
  pinball_contact* contact = nullptr;
  EXPECT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, nullptr), PINBALL_CONTACT_NULL_POINTER);
  const auto create = [&](const pinball_contact_options* options, const pinball_contact_mesh* mesh,
                          const pinball_contact_input* position, const char* named) {
    EXPECT_EQ(pinball_contact_create(options, mesh, position, &contact), PINBALL_CONTACT_NULL_POINTER);
    EXPECT_EQ(pinball_contact_message(contact), std::string(named) + ": is null");
    pinball_contact_destroy(contact);
  };
  create(nullptr, &c.mesh, &c.start, "options");
  create(&c.options, nullptr, &c.start, "mesh");
  create(&c.options, &c.mesh, nullptr, "position");
  EXPECT_EQ(pinball_contact_update(nullptr, &c.arrays, 0), PINBALL_CONTACT_NULL_POINTER);
  EXPECT_EQ(pinball_contact_add_forces(nullptr, &c.arrays, 0, nullptr), PINBALL_CONTACT_NULL_POINTER);
  pinball_contact_options_init(nullptr);
  pinball_contact_mesh_init(nullptr);
  pinball_contact_arrays_init(nullptr);
  pinball_contact_destroy(nullptr);
}

/// Errors of a step, then the same step with what is right: as if they had not been.
void expect_harmless(const std::vector<Wrong>& all, std::int32_t enforcement, bool in_update) {
  std::vector<double> expected;
  for (std::size_t i = 0; i <= all.size(); ++i) {  // at first without an error
    Case c;
    c.options.enforcement = enforcement;
    pinball_contact* contact = nullptr;
    ASSERT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, &contact), PINBALL_CONTACT_OK)
        << pinball_contact_message(contact);
    const auto step = [&](Case& with) {
      const int updated = pinball_contact_update(contact, &with.arrays, with.dt_before);
      if (updated != PINBALL_CONTACT_OK || in_update) return updated;
      return pinball_contact_add_forces(contact, &with.arrays, with.dt_after, nullptr);
    };
    if (i > 0) {
      const Wrong& wrong = all[i - 1];
      Case bad;
      wrong.change(bad);
      const auto same = [](const std::vector<double>& a, const std::vector<double>& b) {
        return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
      };
      const std::vector<double> position = bad.position, velocity = bad.velocity, force = bad.force;
      EXPECT_EQ(step(bad), wrong.status) << wrong.what;
      expect_message(contact, wrong);
      EXPECT_TRUE(same(bad.position, position) && same(bad.velocity, velocity) && same(bad.force, force)) << wrong.what;
    }
    if (in_update || i == 0) {
      ASSERT_EQ(pinball_contact_update(contact, &c.arrays, c.dt_before), PINBALL_CONTACT_OK);
    }
    pinball_contact_result result{};
    ASSERT_EQ(pinball_contact_add_forces(contact, &c.arrays, c.dt_after, &result), PINBALL_CONTACT_OK);
    EXPECT_STREQ(pinball_contact_message(contact), "");
    if (i == 0) {
      expected = c.force;
      EXPECT_EQ(result.pairs, enforcement == PINBALL_CONTACT_PENALTY ? 1 : 12)
          << "two balls, or four corners by three rows";
      EXPECT_NE(c.force, Case().force);
    } else {
      EXPECT_EQ(c.force, expected) << all[i - 1].what;
    }
    pinball_contact_destroy(contact);
  }
}

TEST(EmbeddedErrors, OfUpdateLeaveEverythingAsItWas) {
  const std::vector<Wrong> all = {
      {"size", [](Case& c) { c.arrays.size = 1; }, PINBALL_CONTACT_BAD_VERSION, "arrays->size"},
      {"position", [](Case& c) { c.arrays.position.x = nullptr; }, PINBALL_CONTACT_NULL_POINTER, "arrays->position"},
      {"velocity", [](Case& c) { c.arrays.velocity.z = nullptr; }, PINBALL_CONTACT_NULL_POINTER, "arrays->velocity"},
      {"stride", [](Case& c) { c.arrays.velocity.stride = -3; }, PINBALL_CONTACT_BAD_COUNT, "arrays->velocity.stride"},
      {"place", [](Case& c) { c.position[3 * 9 + 2] = nan; }, PINBALL_CONTACT_BAD_NUMBER, "arrays->position: node 9"},
      {"far", [](Case& c) { c.position[3 * 16] = infinite; }, PINBALL_CONTACT_BAD_NUMBER, "arrays->position: node 16"},
      {"speed", [](Case& c) { c.velocity[0] = nan; }, PINBALL_CONTACT_BAD_NUMBER, "arrays->velocity: node 0"},
      {"far stride", [](Case& c) { c.arrays.position.stride = std::int64_t{1} << 59; }, PINBALL_CONTACT_BAD_COUNT,
       "arrays->position.stride"},
      {"fast", [](Case& c) { c.velocity[3 * 8] = -1e300; }, PINBALL_CONTACT_BAD_NUMBER, "arrays->velocity: node 8"},
      {"step", [](Case& c) { c.dt_before = -1; }, PINBALL_CONTACT_BAD_NUMBER, "dt_before"},
  };
  expect_harmless(all, PINBALL_CONTACT_PENALTY, true);
  expect_harmless(all, PINBALL_CONTACT_LAGRANGE, true);
}

TEST(EmbeddedErrors, OfAddForcesLeaveEverythingAsItWas) {
  std::vector<Wrong> all = {
      {"no force", [](Case& c) { c.arrays.force.y = nullptr; }, PINBALL_CONTACT_NULL_POINTER, "arrays->force"},
      {"stride", [](Case& c) { c.arrays.force.stride = 0; }, PINBALL_CONTACT_BAD_COUNT, "arrays->force.stride"},
      {"records", [](Case& c) { c.arrays.force_records = 1; }, PINBALL_CONTACT_BAD_OPTION, "arrays->force_records"},
      {"step", [](Case& c) { c.dt_after = nan; }, PINBALL_CONTACT_BAD_NUMBER, "dt_after"},
  };
  all.push_back({"far stride", [](Case& c) { c.arrays.force.stride = std::numeric_limits<std::int64_t>::max(); },
                 PINBALL_CONTACT_BAD_COUNT, "arrays->force.stride"});
  all.push_back({"long step", [](Case& c) { c.dt_after = 1e300; }, PINBALL_CONTACT_BAD_NUMBER, "dt_after"});
  all.push_back(
      {"force", [](Case& c) { c.force[3 * 4 + 1] = nan; }, PINBALL_CONTACT_BAD_NUMBER, "arrays->force: node 4"});
  all.push_back({"large force", [](Case& c) { c.force[3 * 4 + 1] = 1e300; }, PINBALL_CONTACT_BAD_NUMBER,
                 "arrays->force: node 4"});
  expect_harmless(all, PINBALL_CONTACT_PENALTY, false);
  expect_harmless(all, PINBALL_CONTACT_LAGRANGE, false);
}

TEST(EmbeddedErrors, CallsOutOfTurnAreRefused) {
  Case c;
  pinball_contact* contact = nullptr;
  ASSERT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, &contact), PINBALL_CONTACT_OK);
  EXPECT_EQ(pinball_contact_add_forces(contact, &c.arrays, 1e-4, nullptr), PINBALL_CONTACT_BAD_ORDER);
  EXPECT_EQ(pinball_contact_update(contact, &c.arrays, 1e-4), PINBALL_CONTACT_OK);
  EXPECT_EQ(pinball_contact_update(contact, &c.arrays, 1e-4), PINBALL_CONTACT_BAD_ORDER);
  EXPECT_EQ(c.force, Case().force);
  EXPECT_EQ(pinball_contact_add_forces(contact, &c.arrays, 1e-4, nullptr), PINBALL_CONTACT_OK);
  pinball_contact_destroy(contact);
}

TEST(EmbeddedErrors, HooksAreTold) {
  struct Told {
    std::vector<std::string> notes, errors, failed;
  } told;
  Case c;
  c.options.log_user = c.options.failed_user = &told;
  c.options.log = [](void* user, int level, const char* message) {
    auto& all = *static_cast<Told*>(user);
    (level == PINBALL_CONTACT_NOTE ? all.notes : all.errors).emplace_back(message);
  };
  c.options.failed = [](void* user, const char* expression, const char* /*file*/, int /*line*/) {
    static_cast<Told*>(user)->failed.emplace_back(expression);
  };
  pinball_contact* contact = nullptr;
  ASSERT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, &contact), PINBALL_CONTACT_OK);
  ASSERT_EQ(told.notes.size(), 1U);
  EXPECT_NE(told.notes[0].find("3 elements and spheres"), std::string::npos) << told.notes[0];
  EXPECT_EQ(pinball_contact_update(contact, nullptr, 0), PINBALL_CONTACT_NULL_POINTER);
  ASSERT_EQ(told.errors.size(), 1U);
  EXPECT_EQ(told.errors[0], pinball_contact_message(contact));
  EXPECT_TRUE(told.failed.empty());
  // Energies that no number can hold.
  for (std::size_t i = 2; i < c.velocity.size(); i += 3) c.velocity[i] = i < 24 ? 1e154 : -1e154;
  EXPECT_EQ(pinball_contact_update(contact, &c.arrays, 1e-4), PINBALL_CONTACT_OK);
  EXPECT_EQ(pinball_contact_add_forces(contact, &c.arrays, 1e-4, nullptr), PINBALL_CONTACT_FAILED);
  EXPECT_EQ(told.failed.size(), 1U);
  EXPECT_EQ(pinball_contact_update(contact, &c.arrays, 1e-4), PINBALL_CONTACT_FAILED) << "it is of no use any more";
  pinball_contact_destroy(contact);
}

TEST(EmbeddedErrors, WhatHooksThrowGoesNoFurther) {
  Case c;
  c.options.log = [](void*, int, const char*) { throw std::runtime_error("of the host"); };
  c.options.failed = [](void*, const char*, const char*, int) { throw 7; };
  pinball_contact* contact = nullptr;
  ASSERT_EQ(pinball_contact_create(&c.options, &c.mesh, &c.start, &contact), PINBALL_CONTACT_OK);
  EXPECT_EQ(pinball_contact_update(contact, nullptr, 0), PINBALL_CONTACT_NULL_POINTER);
  EXPECT_STREQ(pinball_contact_message(contact), "arrays: is null");
  ASSERT_EQ(pinball_contact_update(contact, &c.arrays, 0), PINBALL_CONTACT_OK);
  EXPECT_EQ(pinball_contact_add_forces(contact, &c.arrays, 1e-4, nullptr), PINBALL_CONTACT_OK);
  for (std::size_t i = 2; i < c.velocity.size(); i += 3) c.velocity[i] = i < 24 ? 1e154 : -1e154;
  EXPECT_EQ(pinball_contact_update(contact, &c.arrays, 1e-4), PINBALL_CONTACT_OK);
  EXPECT_EQ(pinball_contact_add_forces(contact, &c.arrays, 1e-4, nullptr), PINBALL_CONTACT_FAILED);
  pinball_contact_destroy(contact);
}

}  // namespace
}  // namespace pinball::embedded_errors_test
