#include <fmt/format.h>

#include <solver/output/page/page.hpp>
#include <solver/output/page/resources.hpp>
#include <solver/program/process/viewer.hpp>
#include <solver/program/result_file.hpp>

#include "convergence_report.hpp"
#include "costs/cost_report.hpp"

namespace pinball {

namespace {

/// The coarsest and the finest mesh whose runs came to their ends.
std::pair<const StudyMesh*, const StudyMesh*> ends_of(const ConvergenceStudy& study) {
  const StudyMesh *coarse = nullptr, *fine = nullptr;
  for (const StudyMesh& mesh : study.meshes) {
    if (!mesh.run.results) continue;
    if (coarse == nullptr) coarse = &mesh;
    fine = &mesh;
  }
  return {coarse, fine};
}

}  // namespace

std::string convergence_page(const ConvergenceStudy& study, const std::string& pictures) {
  const std::string title = study.title.empty() ? study.scene : study.title, found = search_sentence(study);
  const std::string sentence = convergence_sentence(study);
  PageContent content;
  content.title = fmt::format("{} - how wrong its numbers are", study.scene);
  content.body = fill_template(page_resource("convergence.html"),
                               {{"scene", html_text(study.scene)},
                                {"heading", html_text(title)},
                                {"sentence", html_text(found.empty() ? sentence : found + ". " + sentence)},
                                {"pictures", html_text(pictures)},
                                {"status", study.failed() ? "failed" : "done"}});
  content.scripts = {"format.js", "axes.js", "plot.js", "convergence.js"};
  content.blocks = {{"study", convergence_json(study)}};
  return make_page(content);
}

void draw_into_page(const ConvergenceStudy& study, const std::string& path) {
  const auto [coarse, fine] = ends_of(study);
  if (fine == coarse) return;
  const std::string problem = draw_with_viewer({coarse->run.folder, "--beside", fine->run.folder, "--page", path});
  if (!problem.empty()) write_result_file(path, convergence_page(study, "No pictures: " + problem));
}

}  // namespace pinball
