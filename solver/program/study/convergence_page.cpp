#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <solver/output/page/page.hpp>
#include <solver/output/page/resources.hpp>
#include <solver/output/page/surface/surface_block.hpp>
#include <solver/output/page/units_json.hpp>
#include <solver/program/process/viewer.hpp>
#include <solver/program/result_file.hpp>

#include "convergence_report.hpp"
#include "costs/cost_report.hpp"

namespace pinball {

namespace {

/// Of the meshes whose runs came to their ends the coarsest and the finest; one, where no other did.
std::vector<const StudyMesh*> ends_of(const ConvergenceStudy& study) {
  std::vector<const StudyMesh*> ends;
  for (const StudyMesh& mesh : study.meshes) {
    if (!mesh.run.results) continue;
    if (ends.size() == 2) ends.pop_back();
    ends.push_back(&mesh);
  }
  return ends;
}

/// [{mesh, surface}], as convergence.js has it.
std::string surfaces_json(const std::vector<const StudyMesh*>& meshes, const std::vector<std::string>& bodies) {
  std::string list;
  for (const StudyMesh* const mesh : meshes) {
    list += fmt::format("{}{{\"mesh\":\"{}\",\"surface\":{}}}", list.empty() ? "" : ",", mesh->factor.text(),
                        surface_json_of_run(mesh->run.folder, bodies, nullptr, nullptr));
  }
  return '[' + list + ']';
}

/// pictures: what stands in their place as long as there are none.
std::string page_of(const ConvergenceStudy& study, const std::string& surfaces, const std::string& pictures) {
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
  content.scripts = scripts_with_viewer({"convergence.js"});
  content.blocks = {{"units", units_json(parse_units(study.units)).dump()},
                    {"study", convergence_json(study)},
                    {"surfaces", surfaces}};
  return make_page(content);
}

}  // namespace

void write_convergence_page(const ConvergenceStudy& study, const std::string& path) {
  const std::vector<const StudyMesh*> ends = ends_of(study);
  const std::string surfaces = surfaces_json(ends, study.bodies);
  write_result_file(path, page_of(study, surfaces, "One run is no picture of what meshes do."));
  if (ends.size() < 2) return;
  const std::string problem =
      draw_with_viewer({ends.front()->run.folder, "--beside", ends.back()->run.folder, "--page", path});
  if (!problem.empty()) write_result_file(path, page_of(study, surfaces, "No pictures: " + problem));
}

}  // namespace pinball
