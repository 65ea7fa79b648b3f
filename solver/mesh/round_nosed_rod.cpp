#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <solver/base/error.hpp>

#include "generators.hpp"
#include "section.hpp"

/// Every node has a closed formula of its block coordinates, so that a finer mesh samples the same smooth map.
/// Names: a "column" is one of the points on the boundary of the core's section, counted over the half circle from
/// (radius, 0) to (-radius, 0); i, j, k count along x, y, z in the core; m counts from the core (0) outward (ring).
namespace pinball {
namespace {

constexpr double half_turn = std::numbers::pi;

// Shape of the core, beside core_edge and core_bulge, and chosen with them. Lengths in units of the radius.
constexpr double nose_corner = 1.04;   // distance core corner - centre of the nose, over corner - axis in the section
constexpr double taper_length = 0.2;   // the core begins to taper so far behind the centre of the nose
constexpr double zone_length = 1.0;    // length of the cylinder whose layers adapt to the nose
constexpr double column_length = 0.5;  // of the columns in the nose, on the short side: sets how many layers end there

class RoundNosedRod {
 public:
  explicit RoundNosedRod(const RoundNosedRodMesh& settings);
  Mesh half() const;

 private:
  struct Direction {  // of a column, seen along the axis
    double x, y;
  };

  Direction column_direction(int s) const;
  Point cap_direction(int i, int j) const;  // from the nose's centre, unit length
  double core_section_radius(int s) const;  // over the radius
  Point section_core_point(int i, int j) const;
  Point core_end_point(int i, int j) const;
  Point core_point(int i, int j, int k) const;
  Point surface_point(int s, int k) const;
  Point cap_surface_point(int i, int j) const;

  int boundary_column(int i, int j) const;  // column at a point of the core's grid, or -1 inside
  std::array<int, 2> column_core_index(int s) const;
  double graded(double length, double u) const;

  std::int32_t section_node(int m, int s, int k) const;
  std::int32_t core_node(int i, int j, int k) const { return k * section_nodes_ + j * (p_ + 1) + i; }
  std::int32_t cap_node(int m, int i, int j) const;

  double length_, radius_;
  int p_, q_, b_, n_;
  int columns_;  // elements of the ring along the half circle
  std::int32_t section_nodes_;
  double corner_angle_;     // of the core's corner, from the y axis [rad]
  double core_scale_;       // distance of the section's core corner from the axis, over the radius
  double cap_tangent_;      // tangent of half the angle that the cap spans in x
  int zone_layers_;         // layers that adapt to the nose, the rest is a uniform sweep
  double zone_begin_;       // z where they begin
  double layer_thickness_;  // of the uniform sweep
};

/// Angle of the cap such that the cap's arcs through the pole are as long, in the geometric mean, as the surface's arcs
/// along the circumference.
double find_cap_tangent(int p, int q, double corner_angle) {
  const double arc = half_turn / (p + 2 * q);
  const double slope = 1.0 / std::tan(corner_angle);
  double low = 0.0, high = std::sin(corner_angle) * std::tan(1.13);  // the corner stays within 65 degrees of the pole
  for (int iteration = 0; iteration < 60; ++iteration) {
    const double middle = 0.5 * (low + high);
    const bool small = std::atan(middle) / (0.5 * p) * std::atan(middle * slope) / q < arc * arc;
    (small ? low : high) = middle;
  }
  return high;
}

RoundNosedRod::RoundNosedRod(const RoundNosedRodMesh& settings)
    : length_(settings.length),
      radius_(settings.radius),
      p_(settings.core[0]),
      q_(settings.core[1]),
      b_(settings.ring),
      n_(settings.layers),
      columns_(p_ + 2 * q_),
      section_nodes_((p_ + 1) * (q_ + 1) + (columns_ + 1) * b_),
      corner_angle_(0.5 * half_turn * p_ / columns_),
      core_scale_(1.0 / (1.0 + core_edge * half_turn / columns_ * b_)),
      cap_tangent_(find_cap_tangent(p_, q_, corner_angle_)) {
  const double cylinder = length_ - radius_;
  const double nose = column_length * radius_;
  layer_thickness_ = (cylinder + nose) / n_;
  const double zone = std::min(zone_length * radius_, cylinder) + nose;
  zone_layers_ = static_cast<int>(std::round(std::min<double>(n_, zone / layer_thickness_)));
  if (zone_layers_ * layer_thickness_ < nose) ++zone_layers_;  // the zone is to begin on the cylinder
  zone_layers_ = std::clamp(zone_layers_, 1, n_);
  zone_begin_ = -length_ + (n_ - zone_layers_) * layer_thickness_;
}

RoundNosedRod::Direction RoundNosedRod::column_direction(int s) const {
  // Angles from the y axis are odd about the middle, which makes the two sides in x exact mirror images.
  const double angle = 0.5 * half_turn * (columns_ - 2 * s) / columns_;
  return {std::sin(angle), s == 0 || s == columns_ ? 0.0 : std::cos(angle)};
}

Point RoundNosedRod::cap_direction(int i, int j) const {
  // Boundary directions have the azimuth of their column, so that the ring's columns are meridians of the nose.
  const double x = cap_tangent_ * std::tan(corner_angle_ * (2 * i - p_) / p_) / std::tan(corner_angle_);
  const double y = cap_tangent_ * std::tan(half_turn * j / columns_);
  const double norm = std::sqrt(x * x + y * y + 1.0);
  return {x / norm, y / norm, 1.0 / norm};
}

std::array<int, 2> RoundNosedRod::column_core_index(int s) const {
  if (s <= q_) return {p_, s};
  if (s <= q_ + p_) return {p_ - (s - q_), q_};
  return {0, columns_ - s};
}

int RoundNosedRod::boundary_column(int i, int j) const {
  if (i == p_) return j;
  if (i == 0) return columns_ - j;
  return j == q_ ? q_ + p_ - i : -1;
}

double RoundNosedRod::core_section_radius(int s) const {
  const Direction direction = column_direction(s);
  const bool top = s >= q_ && s <= q_ + p_;
  const double flat = top ? std::cos(corner_angle_) / direction.y : std::sin(corner_angle_) / std::abs(direction.x);
  return core_scale_ * ((1.0 - core_bulge) * flat + core_bulge);
}

Point RoundNosedRod::section_core_point(int i, int j) const {
  const auto boundary = [&](int bi, int bj) {
    const int s = boundary_column(bi, bj);
    const Direction direction = column_direction(s);
    const double r = radius_ * core_section_radius(s);
    return std::array<double, 2>{r * direction.x, r * direction.y};
  };
  if (const int s = boundary_column(i, j); s >= 0) return {boundary(i, j)[0], boundary(i, j)[1], 0.0};
  // Transfinite interpolation between the sides, the top and the cut.
  const double u = static_cast<double>(i) / p_, v = static_cast<double>(j) / q_;
  Point point{};
  for (int axis = 0; axis < 2; ++axis) {
    const auto cut = [&](double w) { return (1 - w) * boundary(0, 0)[axis] + w * boundary(p_, 0)[axis]; };
    const double across = (1 - u) * boundary(0, j)[axis] + u * boundary(p_, j)[axis];
    const double along = (1 - v) * cut(u) + v * boundary(i, q_)[axis];
    const double corners = (1 - v) * cut(u) + v * ((1 - u) * boundary(0, q_)[axis] + u * boundary(p_, q_)[axis]);
    point[axis] = across + along - corners;
  }
  if (j == 0) point[1] = 0.0;
  return point;
}

Point RoundNosedRod::core_end_point(int i, int j) const {
  const Point direction = cap_direction(i, j);
  const double flat = cap_direction(p_, q_)[2] / direction[2];
  const double r = radius_ * core_scale_ * nose_corner * ((1.0 - core_bulge) * flat + core_bulge);
  return {r * direction[0], r * direction[1], r * direction[2] - radius_};
}

/// Position along a column of the adapting zone at the fraction u of its layers: starts with the thickness of the
/// uniform sweep and changes linearly from layer to layer.
double RoundNosedRod::graded(double length, double u) const {
  double slope = zone_layers_ == n_ ? length : layer_thickness_ * zone_layers_;
  slope = std::clamp(slope, 0.5 * length, 1.5 * length);
  return slope * u + (length - slope) * u * u;
}

Point RoundNosedRod::core_point(int i, int j, int k) const {
  Point point = section_core_point(i, j);
  const int uniform_layers = n_ - zone_layers_;
  if (k <= uniform_layers) {
    point[2] = -length_ + k * layer_thickness_;
    return point;
  }
  const Point end = core_end_point(i, j);
  if (k == n_) return end;
  const double u = static_cast<double>(k - uniform_layers) / zone_layers_;
  point[2] = zone_begin_ + graded(end[2] - zone_begin_, u);
  const double taper_begin = std::max(zone_begin_, -(1.0 + taper_length) * radius_);
  const double taper = std::max(0.0, (point[2] - taper_begin) / (end[2] - taper_begin));
  for (int axis = 0; axis < 2; ++axis) point[axis] += taper * taper * (end[axis] - point[axis]);
  return point;
}

Point RoundNosedRod::cap_surface_point(int i, int j) const {
  const Point direction = cap_direction(i, j);
  return {radius_ * direction[0], radius_ * direction[1], radius_ * direction[2] - radius_};
}

Point RoundNosedRod::surface_point(int s, int k) const {
  const auto [i, j] = column_core_index(s);
  if (k == n_) return cap_surface_point(i, j);
  const Direction direction = column_direction(s);
  const int uniform_layers = n_ - zone_layers_;
  if (k <= uniform_layers) return {radius_ * direction.x, radius_ * direction.y, -length_ + k * layer_thickness_};
  // By arc length along the meridian: first the cylinder, then the hemisphere up to the cap.
  const double cylinder = -radius_ - zone_begin_;
  const double end = cylinder + radius_ * std::asin(cap_direction(i, j)[2]);
  const double arc = graded(end, static_cast<double>(k - uniform_layers) / zone_layers_);
  if (arc <= cylinder) return {radius_ * direction.x, radius_ * direction.y, zone_begin_ + arc};
  const double elevation = (arc - cylinder) / radius_;
  const double r = radius_ * std::cos(elevation);
  return {r * direction.x, r * direction.y, radius_ * std::sin(elevation) - radius_};
}

std::int32_t RoundNosedRod::section_node(int m, int s, int k) const {
  if (m == 0) {
    const auto [i, j] = column_core_index(s);
    return core_node(i, j, k);
  }
  return k * section_nodes_ + (p_ + 1) * (q_ + 1) + (m - 1) * (columns_ + 1) + s;
}

std::int32_t RoundNosedRod::cap_node(int m, int i, int j) const {
  if (m == 0) return core_node(i, j, n_);
  if (const int s = boundary_column(i, j); s >= 0) return section_node(m, s, n_);
  return (n_ + 1) * section_nodes_ + ((m - 1) * q_ + j) * (p_ - 1) + i - 1;
}

Mesh RoundNosedRod::half() const {
  Mesh mesh;
  mesh.nodes.resize(static_cast<std::size_t>(n_ + 1) * section_nodes_ + static_cast<std::size_t>(b_) * q_ * (p_ - 1));
  const auto blend = [&](const Point& inner, const Point& outer, int m) {
    if (m == b_) return outer;
    const double w = static_cast<double>(m) / b_;
    return Point{(1 - w) * inner[0] + w * outer[0], (1 - w) * inner[1] + w * outer[1],
                 (1 - w) * inner[2] + w * outer[2]};
  };
  for (int k = 0; k <= n_; ++k) {
    for (int j = 0; j <= q_; ++j)
      for (int i = 0; i <= p_; ++i) mesh.nodes[core_node(i, j, k)] = core_point(i, j, k);
    for (int s = 0; s <= columns_; ++s) {
      const Point inner = mesh.nodes[section_node(0, s, k)], outer = surface_point(s, k);
      for (int m = 1; m <= b_; ++m) mesh.nodes[section_node(m, s, k)] = blend(inner, outer, m);
    }
  }
  for (int j = 0; j < q_; ++j)
    for (int i = 1; i < p_; ++i)
      for (int m = 1; m <= b_; ++m)
        mesh.nodes[cap_node(m, i, j)] = blend(mesh.nodes[cap_node(0, i, j)], cap_surface_point(i, j), m);

  const std::size_t core_elements = static_cast<std::size_t>(p_) * q_;
  mesh.hexahedra.reserve(n_ * (core_elements + static_cast<std::size_t>(columns_) * b_) + core_elements * b_);
  for (int k = 0; k < n_; ++k) {
    for (int j = 0; j < q_; ++j)
      for (int i = 0; i < p_; ++i)
        mesh.hexahedra.push_back({core_node(i, j, k), core_node(i + 1, j, k), core_node(i + 1, j + 1, k),
                                  core_node(i, j + 1, k), core_node(i, j, k + 1), core_node(i + 1, j, k + 1),
                                  core_node(i + 1, j + 1, k + 1), core_node(i, j + 1, k + 1)});
    for (int m = 0; m < b_; ++m)
      for (int s = 0; s < columns_; ++s)
        mesh.hexahedra.push_back({section_node(m, s, k), section_node(m + 1, s, k), section_node(m + 1, s + 1, k),
                                  section_node(m, s + 1, k), section_node(m, s, k + 1), section_node(m + 1, s, k + 1),
                                  section_node(m + 1, s + 1, k + 1), section_node(m, s + 1, k + 1)});
  }
  for (int m = 0; m < b_; ++m)
    for (int j = 0; j < q_; ++j)
      for (int i = 0; i < p_; ++i)
        mesh.hexahedra.push_back({cap_node(m, i, j), cap_node(m, i + 1, j), cap_node(m, i + 1, j + 1),
                                  cap_node(m, i, j + 1), cap_node(m + 1, i, j), cap_node(m + 1, i + 1, j),
                                  cap_node(m + 1, i + 1, j + 1), cap_node(m + 1, i, j + 1)});
  return mesh;
}

/// Adds the mirror image in y = 0; nodes of that plane are shared.
void add_mirror_image(Mesh& mesh) {
  const std::size_t node_count = mesh.nodes.size(), element_count = mesh.hexahedra.size();
  std::vector<std::int32_t> image(node_count);
  for (std::size_t node = 0; node < node_count; ++node) {
    const Point x = mesh.nodes[node];
    if (x[1] == 0.0) {
      image[node] = node;
    } else {
      image[node] = mesh.nodes.size();
      mesh.nodes.push_back({x[0], -x[1], x[2]});
    }
  }
  for (std::size_t element = 0; element < element_count; ++element) {
    const auto h = mesh.hexahedra[element];
    // The mirror turns the element inside out; exchanging its eta faces turns it back.
    mesh.hexahedra.push_back(
        {image[h[3]], image[h[2]], image[h[1]], image[h[0]], image[h[7]], image[h[6]], image[h[5]], image[h[4]]});
  }
}

void check(const RoundNosedRodMesh& settings) {
  const auto fail = [](const std::string& what) { throw InputError("round_nosed_rod mesh: " + what); };
  if (!std::isfinite(settings.radius) || settings.radius <= 0.0)
    fail(fmt::format("radius: expected a length > 0, got {}", settings.radius));
  if (!std::isfinite(settings.length) || settings.length < settings.radius)
    fail(fmt::format("length: expected at least the radius, {}, got {}", settings.radius, settings.length));
  for (const int count : settings.core)
    if (count < 1) fail(fmt::format("core: expected two integers >= 1, got {}", count));
  if (settings.ring < 1) fail(fmt::format("ring: expected an integer >= 1, got {}", settings.ring));
  if (settings.layers < 1) fail(fmt::format("layers: expected an integer >= 1, got {}", settings.layers));

  const double p = settings.core[0], q = settings.core[1], b = settings.ring, n = settings.layers;
  const double half_nodes = (n + 1) * ((p + 1) * (q + 1) + (p + 2 * q + 1) * b) + b * q * (p - 1);
  if ((settings.half ? 1 : 2) * half_nodes > std::numeric_limits<std::int32_t>::max())
    fail("core, ring, layers: more than 2^31 - 1 nodes");
}

}  // namespace

Mesh generate_round_nosed_rod(const RoundNosedRodMesh& settings) {
  check(settings);
  Mesh mesh = RoundNosedRod(settings).half();
  if (!settings.half) add_mirror_image(mesh);
  return mesh;
}

}  // namespace pinball
