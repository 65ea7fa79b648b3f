#include <string>
#include <variant>
#include <vector>

#include "cases.hpp"
#include "solver_run.hpp"

/// crushed_block: elements that are pressed flat do not turn inside out, and their energy balances.
namespace pinball {

std::vector<VerificationRow> verify_crushed_block(const Scene& scene) {
  std::vector<VerificationRow> rows;
  for (const int n : {1, 2, 4}) {
    Scene finer = scene;
    for (int& count : std::get<BlockMesh>(finer.bodies[0].mesh).elements) count *= n;
    Solver<double> solver(finer);
    run_to_end(solver);
    RunSummary summary;
    fill_summary(solver, summary);
    const std::string of_mesh = ", n = " + std::to_string(n);
    rows.push_back(compare_with_zero("elements inside out at a corner in any step" + of_mesh, summary.inside_out.most,
                                     0, "corners resist, theory.md, 4.5"));
    rows.push_back(compare_with_zero("largest error of the balance" + of_mesh, solver.ledger().balance_error_max(),
                                     0.01, "conservation of energy"));
  }
  return rows;
}

}  // namespace pinball
