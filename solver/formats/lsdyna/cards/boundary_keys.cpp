#include "boundary_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include <solver/base/error.hpp>
#include <solver/formats/lsdyna/layouts/control_cards.hpp>

#include "deck_parts.hpp"

namespace pinball {

std::int64_t set_number(const KeywordBlock& block, std::int64_t id) {
  return id + offset_of(block, &DeckTransform::set);
}

std::int64_t node_number(const KeywordBlock& block, std::int64_t id) {
  return id + offset_of(block, &DeckTransform::node);
}

std::int64_t definition_number(const KeywordBlock& block, std::int64_t id) {
  return id == 0 ? 0 : id + offset_of(block, &DeckTransform::define);
}

std::int64_t curve_number(const KeywordBlock& block, std::int64_t id) {
  return id == 0 ? 0 : id + offset_of(block, &DeckTransform::curve);
}

DeckSpan span_of(const Fields& f) {
  const DeckSpan span{f.number("BIRTH"), f.number("DEATH")};
  constexpr double no_end = 1e19;  // the defaults are 1e20 and 1e28
  return {span.birth, span.death < no_end ? span.death : 0.0};
}

void set_span(const DeckSpan& span, const DeckKeys<TimeSpan>& keys) {
  if (span.birth > 0) keys.set("start", span.birth);
  if (span.death > 0) keys.set("end", span.death);
}

std::vector<std::string> all_bodies(const DeckData& data) {
  std::vector<std::string> bodies;
  for (const DeckPart& part : data.parts) bodies.push_back(part.body);
  return bodies;
}

std::vector<std::string> bodies_of(const DeckData& data, const std::vector<std::int64_t>& parts,
                                   const DeckPlace& place) {
  std::map<std::int64_t, std::string> wanted;
  for (const std::int64_t part : parts) {
    if (auto body = data.body_of(part, place)) wanted.emplace(part, std::move(*body));
  }
  std::vector<std::string> bodies;
  for (auto& [part, body] : wanted) bodies.push_back(std::move(body));
  return bodies;
}

void set_selection(const DeckData& data, const KeywordBlock& block, const Fields& f,
                   const DeckKeys<NodeSelection>& keys) {
  const std::int64_t set = f.integer("NSID"), without = f.integer("NSIDEX"), box = f.integer("BOXID");
  if (set != 0) keys.set("set", std::to_string(set_number(block, set)), "set");
  if (without != 0) keys.set("without", std::to_string(set_number(block, without)), "nsidex");
  if (box == 0) return;
  const KeywordBox& bounds = data.boxes.find(block, box, f.place());
  InnerKeys<Box> inner;
  inner.set("low", bounds.low);
  inner.set("high", bounds.high);
  keys.set("box", inner.value(), "boxid");
}

Point in_system(const DeckData& data, const KeywordBlock& block, std::int64_t system, const Point& vector,
                const DeckPlace& place) {
  if (system == 0) return vector;
  const std::array<Point, 3> axes = data.axes(definition_number(block, system), place);
  Point global{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) global[c] += vector[k] * axes[k][c];
  }
  return global;
}

void set_target(const KeywordBlock& block, bool set, std::int64_t id, const DeckKeys<NodeSelection>& keys) {
  if (set) {
    keys.set("set", std::to_string(set_number(block, id)), "set");
  } else {
    keys.set("nodes", std::vector{node_number(block, id)}, "node");
  }
}

std::vector<std::int32_t> nodes_of_card(const DeckData& data, const KeywordBlock& block, bool set, const Fields& f,
                                        std::size_t field) {
  const std::int64_t id = f.integer(field);
  if (!set) return {data.nodes.find(node_number(block, id))};
  const MeshSet* found = find_set(data.mesh.node_sets, std::to_string(set_number(block, id)));
  if (found == nullptr) return {};
  if (!found->problem.empty()) throw InputError(found->problem);
  return found->members;
}

double end_of_run(const DeckData& data) {
  const auto card = last_card(data, "CONTROL_TERMINATION");
  return card ? data.fields(*card, layout::termination).number("ENDTIM") : std::numeric_limits<double>::infinity();
}

namespace {

/// Of a curve that acts when it has no points: its first value holds before the first, the last one behind the last.
/// Times of the curve count from the birth.
void tell_ends(const DeckData& data, std::int64_t number, const DeckCurve& points, const DeckSpan& used) {
  const double end = end_of_run(data), until = used.death > 0 ? std::min(used.death, end) : end;
  const auto tell = [&](const char* what, const char* which, double time, double value) {
    data.report.understood(fmt::format("*DEFINE_CURVE {} ({}): {} its {} point, at {:.6g}, it keeps the value {:.6g}",
                                       number, points.place.text(), what, which, time, value));
  };
  const double first = points.abscissa.front(), last = points.abscissa.back();
  if (first > 0 && points.ordinate.front() != 0) tell("before", "first", first, points.ordinate.front());
  if (last < until - std::max(used.birth, 0.0) && points.ordinate.back() != 0)
    tell("behind", "last", last, points.ordinate.back());
}

/// A curve of time that OFFA moves to later times is zero before: LS-DYNA adds points at 0 and at 0.999 of OFFA.
DeckCurve with_zero_before(const DeckData& data, std::int64_t number, const DeckCurve& given) {
  const double until = 0.999 * given.moved;
  DeckCurve points = given;
  if (!(until > 0) || points.ordinate.front() == 0) return points;
  if (points.abscissa.front() <= until) {
    data.report.unused(points.place, "*DEFINE_CURVE: zeros before OFFA", "it has points before that");
    return points;
  }
  points.abscissa.insert(points.abscissa.begin(), {0.0, until});
  points.ordinate.insert(points.ordinate.begin(), {0.0, 0.0});
  data.report.understood(fmt::format("*DEFINE_CURVE {} ({}): OFFA: it is 0 up to 0.999 of {:.6g}, as a curve of time",
                                     number, points.place.text(), points.moved));
  return points;
}

void require_increasing(std::int64_t number, const DeckCurve& points) {
  for (std::size_t i = 1; i < points.abscissa.size(); ++i) {
    if (!(points.abscissa[i] > points.abscissa[i - 1]))
      fail_at(points.place, fmt::format("*DEFINE_CURVE {}: expected times that increase, got {} after {}", number,
                                        points.abscissa[i], points.abscissa[i - 1]));
  }
}

}  // namespace

void set_curve(const DeckData& data, const KeywordBlock& block, std::int64_t curve, double scale,
               const DeckPlace& place, const DeckKeys<TimeTable>& keys, const DeckSpan& used) {
  const std::int64_t number = curve_number(block, curve);
  const DeckCurve points = with_zero_before(data, number, data.curve(number, place));
  require_increasing(number, points);
  tell_ends(data, number, points, used);
  std::vector<double> factors = points.ordinate;
  for (double& factor : factors) factor *= scale == 0 ? 1.0 : scale;
  std::vector<double> times = points.abscissa;
  for (double& time : times) time += std::max(used.birth, 0.0);
  keys.set("times", times, used.birth > 0 ? "lcid, birth" : "lcid");
  keys.set("factors", factors, "lcid, sf");
}

}  // namespace pinball
