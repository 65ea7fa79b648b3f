#include "mesh_factor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <numeric>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/scene/schema/kinds.hpp>

#include "numbered_sets.hpp"

namespace pinball {

namespace {

constexpr int most_times = 1000;               ///< numerator and denominator, as of --refine
constexpr std::int64_t most_in_line = 100000;  ///< elements in one direction

/// The numbers of elements of a mesh, all that --refine multiplies: count(key, number), even: it has to be.
template <class Count>
class CountVisitor {
 public:
  explicit CountVisitor(const Count& count) : count_(count) {}

  void operator()(BlockMesh& mesh) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (mesh.sections[k].empty()) {
        count_("elements", mesh.elements[k], false);
        continue;
      }
      mesh.elements[k] = 0;
      for (BlockSection& section : mesh.sections[k]) {
        count_("elements", section.elements, false);
        mesh.elements[k] += section.elements;
      }
    }
  }
  void operator()(SphereMesh& mesh) const {
    const bool wedge = mesh.section == Section::wedge;
    count_("core", mesh.core[0], is_cut(mesh.section));
    if (wedge) count_("core", mesh.core[1], false);
    if (!wedge) mesh.core[1] = mesh.core[0];
    visit_keys(mesh, false);
  }
  void operator()(CylinderMesh& mesh) const { visit_keys(mesh, is_cut(mesh.section)); }
  void operator()(RoundNosedRodMesh& mesh) const { visit_keys(mesh, false); }
  void operator()(FileMesh&) const {}
  void operator()(ArrayMesh&) const {}

 private:
  static bool is_cut(Section section) { return section != Section::full && section != Section::wedge; }

  /// Counts that are members of their own; cut: that of the core has to be even.
  template <class Mesh>
  void visit_keys(Mesh& mesh, bool cut) const {
    describe(schema::Of<Mesh>{}, [&](const auto& key) {
      if constexpr (requires { key.member, key.about; }) {
        if (key.about.form != schema::Form::count || (key.applies && !key.applies(mesh))) return;
        auto& value = mesh.*key.member;
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, int>) {
          count_(key.name, value, cut && std::string_view(key.name) == "core");
        } else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::array<int, 2>>) {
          for (int& one : value) count_(key.name, one, false);
        }
      }
    });
  }

  const Count& count_;
};

template <class Count>
void visit_counts(Body& body, const Count& count) {
  std::visit(CountVisitor<Count>(count), body.mesh);
}

std::optional<MeshFactor> parse_factor(std::string_view text) {
  const auto number = [](std::string_view part, int& value) {
    const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), value);
    return problem == std::errc() && end == part.data() + part.size() && value >= 1 && value <= most_times;
  };
  MeshFactor factor;
  const std::size_t slash = std::min(text.find('/'), text.size());
  if (!number(text.substr(0, slash), factor.numerator)) return std::nullopt;
  if (slash < text.size() && !number(text.substr(slash + 1), factor.denominator)) return std::nullopt;
  const int common = std::gcd(factor.numerator, factor.denominator);
  return MeshFactor{factor.numerator / common, factor.denominator / common};
}

bool is_of_file(const Body& body) { return std::holds_alternative<FileMesh>(body.mesh); }

/// Splits each hexahedron in eight until there are so many in each direction.
void split_by(FileMesh& mesh, const MeshFactor& factor, const std::string& body) {
  const auto times = static_cast<unsigned>(factor.numerator);
  if (factor.denominator != 1 || !std::has_single_bit(times)) {
    throw InputError(
        fmt::format("body.{}.mesh.file: expected factors 1, 2, 4, ..., got {}: the elements of a file are split "
                    "in eight; --meshes names others",
                    body, factor.text()));
  }
  mesh.splits += std::bit_width(times) - 1;
}

void refine(Body& body, const MeshFactor& factor) {
  if (auto* file = std::get_if<FileMesh>(&body.mesh)) split_by(*file, factor, body.name);
  visit_counts(body, [&](const char* key, int& count, bool even) {
    const auto fail = [&](const std::string& what) {
      throw InputError(fmt::format("body.{}.mesh.{}: expected a number that {}, got {}; --meshes names others",
                                   body.name, key, what, count));
    };
    const std::int64_t times = std::int64_t{count} * factor.numerator;
    if (times % factor.denominator != 0) fail(fmt::format("{} times leaves whole", factor.text()));
    const std::int64_t result = times / factor.denominator;
    if (even && result % 2 != 0) {
      fail(fmt::format("is even {} times, since the section is cut through it", factor.text()));
    }
    if (result > most_in_line) fail(fmt::format("is at most {} {} times", most_in_line, factor.text()));
    count = result;
  });
}

void require_own_file(const Scene& scene, const Body& body) {
  const auto* mine = std::get_if<FileMesh>(&body.mesh);
  if (mine == nullptr) return;
  for (const Body& other : scene.bodies) {
    const auto* theirs = std::get_if<FileMesh>(&other.mesh);
    if (theirs == nullptr || other.name == body.name || theirs->file != mine->file) continue;
    throw InputError(fmt::format("--refine {}: expected a body with a file of its own, {} shares nodes of {} with it",
                                 body.name, other.name, mine->file));
  }
}

bool can_be_refined(const Scene& scene, const MeshFactor& factor) {
  try {
    refined_by(scene, factor);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool is_finer(const MeshFactor& a, const MeshFactor& b) { return a.value() < b.value(); }

}  // namespace

std::string MeshFactor::text() const {
  return denominator == 1 ? fmt::format("{}", numerator) : fmt::format("{}/{}", numerator, denominator);
}

std::vector<MeshFactor> parse_mesh_factors(const std::string& text) {
  const auto fail = [&text](const std::string& problem) {
    throw InputError(
        fmt::format("--meshes {}: expected three different factors of the numbers of elements or more, as in 1/2,1,2{}",
                    text, problem));
  };
  std::vector<MeshFactor> factors;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    const auto factor = parse_factor(part);
    if (!factor) fail(fmt::format(", got \"{}\"", part));
    factors.push_back(*factor);
    begin = end + 1;
  }
  std::sort(factors.begin(), factors.end(), is_finer);
  if (std::adjacent_find(factors.begin(), factors.end()) != factors.end()) fail(", got one twice");
  if (factors.size() < 3) fail(fmt::format(", got {}", factors.size()));
  return factors;
}

std::vector<MeshFactor> default_mesh_factors(const Scene& scene) {
  const bool any_of_file = std::any_of(scene.bodies.begin(), scene.bodies.end(), is_of_file);
  if (!any_of_file && can_be_refined(scene, {1, 2})) return {{1, 2}, {1, 1}, {2, 1}};
  return {{1, 1}, {2, 1}, {4, 1}};
}

void require_refinable(const Scene& scene) {
  if (std::any_of(scene.bodies.begin(), scene.bodies.end(), is_of_file)) require_numbers_that_carry(scene);
  if (scene.time.steps >= 0) {
    throw InputError(fmt::format("time.steps = {}: expected none, so many steps of another mesh end at another time",
                                 scene.time.steps));
  }
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    if (!scene.loads[i].each) continue;
    throw InputError(
        fmt::format("load.{}.each: expected false, a force on each node is another load on another mesh", i));
  }
  for (std::size_t i = 0; i < scene.point_masses.size(); ++i) {
    if (!scene.point_masses[i].each) continue;
    throw InputError(
        fmt::format("point_mass.{}.each: expected false, a mass of each node is another one on another mesh", i));
  }
}

Scene refined_by(const Scene& scene, const MeshFactor& factor) {
  Scene refined = scene;
  for (Body& body : refined.bodies) refine(body, factor);
  return refined;
}

Scene refined_body(const Scene& scene, const std::string& name, const MeshFactor& factor) {
  Scene refined = scene;
  std::vector<std::string> names;
  for (Body& body : refined.bodies) {
    names.push_back(body.name);
    if (body.name != name) continue;
    require_own_file(scene, body);
    refine(body, factor);
    return refined;
  }
  throw InputError(fmt::format("--refine {}={}: expected one of the bodies, nearest is {}", name, factor.text(),
                               nearest(name, names)));
}

std::optional<MeshFactor> least_mesh_factor(const Scene& scene, double least, double most) {
  std::optional<MeshFactor> found;
  for (int denominator = 1; denominator <= 8; ++denominator) {
    const double first = std::max(1.0, std::ceil(least * denominator - 1e-9));
    for (double n = first; n <= std::min<double>(most_times, most * denominator + 1e-9); ++n) {
      const int numerator = static_cast<int>(n), common = std::gcd(numerator, denominator);
      const MeshFactor factor{numerator / common, denominator / common};
      if (found && !is_finer(factor, *found)) break;
      if (can_be_refined(scene, factor)) found = factor;
    }
  }
  return found;
}

std::string element_counts(const Scene& scene) {
  std::vector<std::string> bodies;
  for (Body body : scene.bodies) {
    std::vector<std::pair<std::string, std::string>> keys;
    visit_counts(body, [&](const char* key, int count, bool) {
      if (keys.empty() || keys.back().first != key) {
        keys.emplace_back(key, fmt::format("{}", count));
      } else {
        keys.back().second += fmt::format(" x {}", count);
      }
    });
    std::string text;
    if (const auto* file = std::get_if<FileMesh>(&body.mesh)) {
      text = std::filesystem::path(file->file).filename().string();
      if (file->splits > 0) text += fmt::format(", each element in {}", 1LL << (3 * file->splits));
    }
    for (const auto& [key, counts] : keys) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, counts);
    bodies.push_back(fmt::format("{}: {}", body.name, text));
  }
  return fmt::format("{}", fmt::join(bodies, "; "));
}

}  // namespace pinball
