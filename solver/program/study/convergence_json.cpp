#include <nlohmann/json.hpp>

#include <solver/base/version.h>

#include "convergence_report.hpp"
#include "costs/cost_report.hpp"
#include "sources_report.hpp"

namespace pinball {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson number_or_null(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson(nullptr);
}

OrderedJson text_or_null(const std::string& text) { return text.empty() ? OrderedJson(nullptr) : OrderedJson(text); }

OrderedJson run_json(const StudyRun& run) {
  return {{"folder", run.folder},
          {"was_there", run.was_there},
          {"failure", text_or_null(run.failure)},
          {"left_out", text_or_null(run.left_out)}};
}

OrderedJson mesh_json(const StudyMesh& mesh) {
  OrderedJson json = {{"factor", mesh.factor.text()}, {"counts", mesh.counts}};
  json.update(run_json(mesh.run));
  for (const char* key : {"elements", "nodes", "steps"}) {
    const auto value = mesh.run.results ? mesh.run.results->value(key) : std::nullopt;
    json[key] = value ? OrderedJson(static_cast<std::int64_t>(*value)) : OrderedJson(nullptr);
  }
  json["wall_seconds"] = number_or_null(mesh.run.results ? mesh.run.results->value("wall_seconds") : std::nullopt);
  return json;
}

OrderedJson source_json(const StudySource& source) {
  OrderedJson runs = OrderedJson::array();
  for (const StudyRun& run : source.runs) runs.push_back(run_json(run));
  return {{"name", source.name}, {"what", source.what}, {"runs", runs}};
}

void add_sources_json(const ConvergenceStudy& study, const StudyQuantity& quantity, OrderedJson& json) {
  json["moved_by"] = {{"mesh", number_or_null(error_of_mesh(study, quantity))}};
  for (std::size_t s = 0; s < study.sources.size(); ++s) {
    json["moved_by"][study.sources[s].name] = number_or_null(quantity.moved[s]);
  }
  json["mean_of_chance"] = number_or_null(quantity.mean_of_chance);
  json["largest_source"] = largest_source(study, quantity);
  json["chance_rules"] = chance_rules(study, quantity);
  json["refine"] = text_or_null(body_to_refine(study, quantity));
}

void add_convergence_json(const GridConvergence& c, OrderedJson& json) {
  const bool monotone = c.verdict == Convergence::monotone;
  const auto if_monotone = [monotone](double value) { return monotone ? OrderedJson(value) : OrderedJson(nullptr); };
  const OrderedJson range = {c.low, c.high};
  json["observed_order"] = number_or_null(c.observed_order);
  json["order"] = if_monotone(c.order);
  json["safety_factor"] = if_monotone(c.safety_factor);
  json["extrapolated"] = c.has_band() ? OrderedJson(c.extrapolated) : OrderedJson(nullptr);
  json["approximate_error"] = c.approximate_error;
  json["extrapolated_error"] = if_monotone(c.extrapolated_error);
  json["index"] = if_monotone(c.index);
  json["band"] = c.has_band() ? range : OrderedJson(nullptr);
  json["spread"] = c.has_band() ? OrderedJson(nullptr) : range;
}

OrderedJson point_json(const CostPoint& point) {
  OrderedJson errors = OrderedJson::array();
  for (const auto& error : point.errors) errors.push_back(number_or_null(error));
  return {{"settings", point.settings},
          {"what", point.what},
          {"factor", point.factor.text()},
          {"variation", text_or_null(point.variation)},
          {"of_chance", point.of_chance},
          {"seconds", point.seconds},
          {"bytes", point.bytes},
          {"elements", static_cast<std::int64_t>(point.elements)},
          {"errors", errors}};
}

OrderedJson cost_json(const ConvergenceStudy& study, const std::vector<CostPoint>& points, std::size_t quantity) {
  const auto known = known_to(study, study.quantities[quantity]);
  const auto found = cheapest(points, {quantity}, error_of_report(study));
  return {{"name", study.quantities[quantity].name},
          {"known_to", known ? OrderedJson(known->error) : OrderedJson(nullptr)},
          {"known_to_chance", known && known->chance},
          {"frontier", frontier(points, quantity)},
          {"cheapest", found ? OrderedJson(*found) : OrderedJson(nullptr)},
          {"sentence", text_or_null(cost_sentence(study, points, quantity))}};
}

OrderedJson quantity_json(const ConvergenceStudy& study, const StudyQuantity& quantity) {
  OrderedJson values = OrderedJson::array();
  for (const auto& value : quantity.values) values.push_back(number_or_null(value));
  OrderedJson json = {{"name", quantity.name}, {"unit", quantity.unit}, {"values", values}, {"scale", quantity.scale}};
  const std::string verdict = verdict_word(quantity);
  json["verdict"] = text_or_null(verdict);
  if (quantity.convergence) {
    add_convergence_json(*quantity.convergence, json);
    json["own_error"] = number_or_null(own_error(study, quantity));
    json["together"] = number_or_null(error_together(study, quantity));
  }
  if (!study.sources.empty()) add_sources_json(study, quantity, json);
  return json;
}

}  // namespace

std::string convergence_json(const ConvergenceStudy& study) {
  OrderedJson meshes = OrderedJson::array(), quantities = OrderedJson::array(), sources = OrderedJson::array();
  OrderedJson points = OrderedJson::array(), costs = OrderedJson::array();
  for (const StudyMesh& mesh : study.meshes) meshes.push_back(mesh_json(mesh));
  const std::vector<CostPoint> all_points = cost_points(study);
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    quantities.push_back(quantity_json(study, study.quantities[q]));
    costs.push_back(cost_json(study, all_points, q));
  }
  for (const CostPoint& point : all_points) points.push_back(point_json(point));
  for (const StudySource& source : study.sources) sources.push_back(source_json(source));
  const OrderedJson json = {{"scene", study.scene},
                            {"title", study.title},
                            {"version", PINBALL_VERSION},
                            {"sentence", convergence_sentence(study)},
                            {"meshes", meshes},
                            {"quantities", quantities},
                            {"sources_mesh", study.meshes[study.sources_mesh].factor.text()},
                            {"sources", sources},
                            {"points", points},
                            {"costs", costs},
                            {"error", error_of_report(study)},
                            {"budget_seconds", number_or_null(study.limits.seconds)},
                            {"search_sentence", text_or_null(search_sentence(study))}};
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

}  // namespace pinball
