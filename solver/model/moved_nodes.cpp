#include "moved_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "place_names.hpp"

namespace pinball {

namespace {

/// What is told: a change of a body's mass over this, and a way over the size of an element around the node.
constexpr double told_mass = 1e-3, told_way = 0.1;

/// How many bodies are named.
constexpr std::size_t most_bodies = 5;

struct BodyVolume {
  double before = 0, now = 0;
  std::size_t body = 0;
  double change() const { return now / before - 1; }
};

std::string text_of(const ModelMesh& mesh, std::vector<BodyVolume>& volumes) {
  std::erase_if(volumes, [](const BodyVolume& volume) { return !(std::abs(volume.change()) > told_mass); });
  std::ranges::stable_sort(
      volumes, [](const BodyVolume& a, const BodyVolume& b) { return std::abs(a.change()) > std::abs(b.change()); });
  std::string text;
  for (std::size_t i = 0; i < std::min(volumes.size(), most_bodies); ++i) {
    text += fmt::format("{}{} by {:+.3g} %", i == 0 ? ", which changes the mass of body " : ", of body ",
                        mesh.body_names[volumes[i].body], 100 * volumes[i].change());
  }
  if (volumes.size() > most_bodies) text += fmt::format(", and of {} more", volumes.size() - most_bodies);
  return text;
}

}  // namespace

std::string MovedNodes::take(const ModelMesh& mesh, const std::string& by) {
  std::vector<double> way(mesh.nodes.size(), 0.0);
  std::size_t furthest = 0;
  for (std::size_t n = 0; n < way.size(); ++n) {
    way[n] = norm(minus(mesh.nodes[n], before_[n]));
    if (way[n] > way[furthest]) furthest = n;
  }
  const std::int64_t moved = std::ranges::count_if(way, [](double length) { return length > 0; });
  if (moved == 0) return "";
  std::vector<BodyVolume> volumes(mesh.body_names.size());
  for (std::size_t b = 0; b < volumes.size(); ++b) volumes[b].body = b;
  double largest_part = 0;
  ModelMesh old;  // no more than what volumes are of
  old.nodes = std::move(before_);
  old.hexahedra = mesh.hexahedra;
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    BodyVolume& body = volumes[mesh.body[e]];
    const double volume = element_volume(old, e);
    double longest = 0;
    for (const std::int32_t n : mesh.hexahedra[e]) longest = std::max(longest, way[n]);
    body.before += volume;
    body.now += longest > 0 ? element_volume(mesh, e) : volume;
    largest_part = std::max(largest_part, longest / std::cbrt(volume));
  }
  before_ = mesh.nodes;
  const std::string masses = text_of(mesh, volumes);
  if (masses.empty() && !(largest_part > told_way)) return "";
  return fmt::format("{} has moved {} {} before the start, {} by {:.4g} the furthest{}", by, moved,
                     moved == 1 ? "node" : "nodes", node_name(mesh, furthest), way[furthest], masses);
}

}  // namespace pinball
