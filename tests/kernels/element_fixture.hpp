#pragma once

#include <kernels/element_update.hpp>
#include <tests/support/support.hpp>

/// Elements and nodes in plain double precision, and one step of the element kernel over them in any number type.
namespace pinball::test {

/// All that a material may keep, in this order.
inline constexpr int material_numbers = 39;
inline constexpr MaterialPlaces material_places{.back_stress = 0,
                                                .temperature = 5,
                                                .energy = 6,
                                                .compaction = 31,
                                                .torn = 32,
                                                .damage = 7,
                                                .hardening = 29,
                                                .bulking = 30,
                                                .beside = 33,
                                                .strain = 8,
                                                .deformation = 14,
                                                .gradient = 20,
                                                .numbers = 39};

struct ElementState {
  double mass = 0;
  Symmetric<double> stress{0, 0, 0, 0, 0, 0};
  double plastic_strain = 0;
  std::array<Vec3<double>, 4> hourglass_state{};  ///< twelve numbers, by threes
  double viscous_stress = 0;
  double internal_energy = 0;
  std::array<double, material_numbers> material{};  ///< of material_places

  double temperature() const { return material[material_places.temperature]; }
  double energy() const { return material[material_places.energy]; }
  double compaction() const { return material[material_places.compaction]; }
  double damage() const { return material[material_places.damage]; }
};

struct ElementScene {
  std::vector<Vec3<double>> position, velocity;
  std::vector<std::array<std::int32_t, 8>> corner;
  std::vector<ElementState> element;
  ElementConstants<double> constants{};
  double dt = 0.01, time = 0;
  bool has_material_state = true, has_viscous_stress = true, has_internal_energy = true;
  double padding = std::numeric_limits<double>::quiet_NaN();  ///< what the state of padding elements holds

  void add(const Corners& x, const Corners& v, const ElementState& state) {
    std::array<std::int32_t, 8> nodes;
    for (std::size_t i = 0; i < 8; ++i) {
      nodes[i] = static_cast<std::int32_t>(position.size());
      position.push_back(x[i]);
      velocity.push_back(v[i]);
    }
    corner.push_back(nodes);
    element.push_back(state);
  }
};

struct ElementOutcome {
  std::vector<ElementState> element;
  std::vector<Vec3<double>> force;
  double internal = 0, hourglass = 0, viscous = 0, eroded = 0, time_step = 0;
  int smallest_element = 0, eroded_count = 0, inverted_count = 0;
};

/// Lambda 150, mu 80, density 3, elastic unless changed; no viscosity.
inline ElementConstants<double> element_constants() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ElementConstants<double> c{};
  c.material = {150, 80, infinity, 10, infinity, 3, std::sqrt(310.0 / 3)};
  c.places = material_places;
  return c;
}

template <class S>
ElementConstants<S> converted(const ElementConstants<double>& c) {
  const MaterialConstants<double>& m = c.material;
  HardeningConstants<S> hardening{};  // its arrays are of doubles
  if constexpr (std::is_same_v<S, double>) hardening = c.hardening;
  const S coefficient(c.hourglass.coefficient), lambda(m.lambda), mu(m.mu);
  ElementConstants<S> to{};
  to.material = {lambda,          mu, S(m.yield_stress), S(m.plastic_modulus), S(m.ultimate_stress), S(m.density),
                 S(m.sound_speed)};
  to.hourglass = {coefficient, coefficient * hourglass_modulus(lambda, mu),
                  assumed_strain_moduli(lambda, mu, coefficient)};
  to.viscosity = {S(c.viscosity.linear), S(c.viscosity.quadratic)};
  to.failure = {S(c.failure.plastic_strain), c.failure.negative_volume, c.failure.inside_out, {}};
  to.specific_volume = S(1) / S(m.density);
  to.hardening = hardening;
  to.never_yields = c.never_yields;
  to.places = c.places;
  if constexpr (std::is_same_v<S, double>) {
    to.johnson_cook = c.johnson_cook;
    to.brittle = c.brittle;
    to.granular = c.granular;
    to.foam = c.foam;
    to.pressure = c.pressure;
    to.fluid = c.fluid;
    to.rubber = c.rubber;
    to.orthotropic = c.orthotropic;
    to.failure.limits = c.failure.limits;
  }
  return to;
}

template <class T, ElementFeatures features>
ElementOutcome advance(const ElementScene& scene) {
  using S = ScalarOf<T>;
  constexpr std::size_t W = width_of<T>;
  const std::size_t count = scene.element.size(), packs = (count + W - 1) / W;

  // Store: entry c of element e at [(e / W) N + c] W + e % W; padding repeats the nodes of element 0 with mass 0.
  AlignedVector<S> position, velocity, force(4 * scene.position.size(), S(0));
  for (std::size_t n = 0; n < scene.position.size(); ++n) {
    for (const double c : {scene.position[n].x, scene.position[n].y, scene.position[n].z, 1e30}) {
      position.push_back(S(c));
    }
    for (const double c : {scene.velocity[n].x, scene.velocity[n].y, scene.velocity[n].z, 1e30}) {
      velocity.push_back(S(c));
    }
  }
  const S padding(scene.padding);
  AlignedVector<std::int32_t> corner(8 * packs * W);
  AlignedVector<S> mass(packs * W, S(0)), stress(6 * packs * W, padding), plastic_strain(packs * W, padding);
  AlignedVector<S> hourglass(12 * packs * W, padding), viscous(packs * W, padding), energy(packs * W, padding);
  AlignedVector<S> material(material_numbers * packs * W, padding);
  const auto place = [](std::size_t e, std::size_t c, std::size_t n) { return ((e / W) * n + c) * W + e % W; };
  for (std::size_t e = 0; e < packs * W; ++e) {
    const std::size_t real = e < count ? e : 0;
    for (std::size_t i = 0; i < 8; ++i) corner[place(e, i, 8)] = scene.corner[real][i];
    if (e >= count) continue;
    const ElementState& s = scene.element[e];
    mass[e] = S(s.mass), plastic_strain[e] = S(s.plastic_strain);
    viscous[e] = S(s.viscous_stress), energy[e] = S(s.internal_energy);
    const double components[6] = {s.stress.xx, s.stress.yy, s.stress.zz, s.stress.xy, s.stress.yz, s.stress.zx};
    for (std::size_t c = 0; c < 6; ++c) stress[place(e, c, 6)] = S(components[c]);
    for (std::size_t c = 0; c < material_numbers; ++c) material[place(e, c, material_numbers)] = S(s.material[c]);
    for (std::size_t a = 0; a < 4; ++a) {
      hourglass[place(e, 3 * a, 12)] = S(s.hourglass_state[a].x);
      hourglass[place(e, 3 * a + 1, 12)] = S(s.hourglass_state[a].y);
      hourglass[place(e, 3 * a + 2, 12)] = S(s.hourglass_state[a].z);
    }
  }

  const ElementView<S> elements{corner.data(),
                                mass.data(),
                                stress.data(),
                                plastic_strain.data(),
                                hourglass.data(),
                                scene.has_viscous_stress ? viscous.data() : nullptr,
                                scene.has_internal_energy ? energy.data() : nullptr,
                                scene.has_material_state ? material.data() : nullptr,
                                nullptr,
                                nullptr,
                                scene.has_material_state ? material_numbers : 0};
  ElementConstants<S> constants = converted<S>(scene.constants);
  if (!scene.has_material_state) constants.places = {};
  const NodeView<S> nodes{position.data(), velocity.data(), force.data()};
  ElementSums<T> sums;
  for (std::size_t p = 0; p < packs; ++p) {
    update_element_pack<T, features>(elements, nodes, constants, ElementStep<S>{S(scene.dt), S(1), S(scene.time)},
                                     std::int64_t(p), int(p), sums, AddedToNodes<S>{nodes.force});
  }

  ElementOutcome out;
  for (std::size_t e = 0; e < packs * W; ++e) {
    if (e >= count) {
      EXPECT_EQ(mass[e], S(0)) << "padding became an element";
      continue;
    }
    ElementState s;
    s.mass = mass[e], s.plastic_strain = plastic_strain[e], s.viscous_stress = viscous[e];
    s.internal_energy = energy[e];
    s.stress = {stress[place(e, 0, 6)], stress[place(e, 1, 6)], stress[place(e, 2, 6)],
                stress[place(e, 3, 6)], stress[place(e, 4, 6)], stress[place(e, 5, 6)]};
    for (std::size_t c = 0; c < material_numbers; ++c) s.material[c] = material[place(e, c, material_numbers)];
    for (std::size_t a = 0; a < 4; ++a) {
      s.hourglass_state[a] = {hourglass[place(e, 3 * a, 12)], hourglass[place(e, 3 * a + 1, 12)],
                              hourglass[place(e, 3 * a + 2, 12)]};
    }
    out.element.push_back(s);
  }
  for (std::size_t n = 0; n < scene.position.size(); ++n) {
    out.force.push_back({force[4 * n], force[4 * n + 1], force[4 * n + 2]});
    EXPECT_EQ(force[4 * n + 3], S(0));
  }
  out.internal = lane_sum(sums.internal), out.hourglass = lane_sum(sums.hourglass);
  out.viscous = lane_sum(sums.viscous), out.eroded = lane_sum(sums.eroded);
  out.time_step = std::numeric_limits<double>::infinity();
  for (int i = 0; i < int(W); ++i) {
    const double rate = lane(sums.stable_rate, i);
    if (2 / rate < out.time_step) {
      out.time_step = 2 / rate;
      out.smallest_element = int(lane(sums.stable_rate_pack, i)) * int(W) + i;
    }
  }
  out.eroded_count = sums.eroded_count, out.inverted_count = sums.inverted_count;
  return out;
}

/// 27 elements that share nodes, jittered, with random velocities and states; some erode, one is eroded already; and an
/// inverted element by itself. 28 elements leave padding in every pack of 8 and 16.
inline ElementScene random_element_scene() {
  Random random(121);
  ElementScene scene;
  constexpr int n = 3, m = n + 1;
  for (int k = 0; k < m; ++k) {
    for (int j = 0; j < m; ++j) {
      for (int i = 0; i < m; ++i) {
        scene.position.push_back(Vec3<double>{double(i), double(j), double(k)} + random_vector(random, 0.15));
        scene.velocity.push_back(random_vector(random));
      }
    }
  }
  const auto random_state = [&random] {
    ElementState s;
    s.mass = uniform(random, 2, 4);
    s.stress = random_symmetric(random, 3);
    s.plastic_strain = uniform(random, 0, 0.1);
    for (Vec3<double>& q : s.hourglass_state) q = random_vector(random, 0.5);
    s.viscous_stress = uniform(random, -1, 1);
    s.internal_energy = uniform(random, 0, 2);
    return s;
  };
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        std::array<std::int32_t, 8> nodes;
        for (std::size_t c = 0; c < 8; ++c) {
          nodes[c] = (i + (parent[c][0] > 0)) + m * ((j + (parent[c][1] > 0)) + m * (k + (parent[c][2] > 0)));
        }
        scene.corner.push_back(nodes);
        scene.element.push_back(random_state());
      }
    }
  }
  for (const std::size_t e : {3, 4, 17}) scene.element[e].plastic_strain = 2;  // will erode
  scene.element[9] = {};                                                       // eroded already
  Corners inverted = box(1, 1, 1), velocity;
  for (std::size_t i = 0; i < 4; ++i) std::swap(inverted[i], inverted[i + 4]);
  for (Vec3<double>& v : velocity) v = random_vector(random);
  for (Vec3<double>& x : inverted) x = x + Vec3<double>{10, 0, 0};
  scene.add(inverted, velocity, random_state());

  scene.constants = element_constants();
  scene.constants.material.yield_stress = 4;
  scene.constants.material.ultimate_stress = 4.5;
  scene.constants.failure.plastic_strain = 1;
  scene.constants.hourglass.coefficient = 0.05;
  scene.constants.viscosity.linear = 0.06;
  scene.constants.viscosity.quadratic = 1.2;
  scene.constants.failure.negative_volume = true;
  scene.dt = 0.01;
  return scene;
}

/// compare: which arrays the features keep; the others are left as they were.
inline void expect_equal(const ElementOutcome& found, const ElementOutcome& expected, ElementFeatures compare,
                         double tolerance) {
  ASSERT_EQ(found.element.size(), expected.element.size());
  for (std::size_t e = 0; e < expected.element.size(); ++e) {
    SCOPED_TRACE(e);
    const ElementState &a = found.element[e], &b = expected.element[e];
    EXPECT_NEAR(a.mass, b.mass, tolerance);
    EXPECT_EQ(a.mass == 0, b.mass == 0);
    EXPECT_SYMMETRIC_NEAR(a.stress, b.stress, 10 * tolerance);
    if (compare.plastic) {
      EXPECT_NEAR(a.plastic_strain, b.plastic_strain, tolerance);
    }
    if (compare.erosion) {
      EXPECT_NEAR(a.internal_energy, b.internal_energy, 10 * tolerance);
    }
    if (compare.bulk_viscosity) {
      EXPECT_NEAR(a.viscous_stress, b.viscous_stress, 10 * tolerance);
    }
    for (std::size_t m = 0; m < 4; ++m) {
      if (stores_hourglass_modes(compare.hourglass)) {
        EXPECT_VECTOR_NEAR(a.hourglass_state[m], b.hourglass_state[m], tolerance);
      }
    }
  }
  for (std::size_t n = 0; n < expected.force.size(); ++n) {
    EXPECT_VECTOR_NEAR(found.force[n], expected.force[n], 20 * tolerance);
  }
  EXPECT_NEAR(found.internal, expected.internal, 20 * tolerance);
  EXPECT_NEAR(found.hourglass, expected.hourglass, 20 * tolerance);
  EXPECT_NEAR(found.viscous, expected.viscous, 20 * tolerance);
  EXPECT_NEAR(found.eroded, expected.eroded, 20 * tolerance);
  EXPECT_NEAR(found.time_step, expected.time_step, tolerance);
  EXPECT_EQ(found.smallest_element, expected.smallest_element);
  EXPECT_EQ(found.eroded_count, expected.eroded_count);
  EXPECT_EQ(found.inverted_count, expected.inverted_count);
}

}  // namespace pinball::test
