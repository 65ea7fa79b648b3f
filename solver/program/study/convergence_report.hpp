#pragma once

#include <string>

#include "convergence_study.hpp"

/// What a study shows. It has at least one mesh.
namespace pinball {

/// What has become of the quantities, and where the scene's own mesh errs most, in a sentence.
std::string convergence_sentence(const ConvergenceStudy& study);

/// The sentence, a line for each mesh and one for each quantity, and what sources_report.hpp has.
std::string convergence_text(const ConvergenceStudy& study);

/// {scene, title, version, sentence, meshes [{factor, counts, folder, was_there, failure, left_out, elements, nodes,
/// steps, wall_seconds}], quantities [{name, unit, values, scale, verdict, observed_order, order, safety_factor,
/// extrapolated, approximate_error, extrapolated_error, index, band, spread, own_error, moved_by {mesh, SOURCE...},
/// mean_of_chance, largest_source, chance_rules, refine}], sources_mesh, sources [{name, what, runs [{folder,
/// was_there, failure, left_out}]}], points [{settings, what, factor, variation, of_chance, seconds, bytes, elements,
/// errors}], costs
/// [{name, known_to, known_to_chance, frontier, cheapest, sentence}], error, budget_seconds, search_sentence}. Costs
/// are of the quantities in their order, their frontier and cheapest numbers of points, from 0. Numbers that are not
/// there, or not finite, are null; of band and spread, [low, high], the one that does not apply. Of a quantity with a
/// value on fewer than three meshes there is nothing from observed_order to own_error.
std::string convergence_json(const ConvergenceStudy& study);

/// A line for each quantity and run, with its value and error beside what its mesh is, took, and what all of them say:
/// quantity,unit,run,mesh,elements,seconds,bytes,value,error,extrapolated,low,high,verdict. What is not known is empty.
std::string convergence_csv(const ConvergenceStudy& study);

/// Writes a page to be opened in a browser, with the bodies of the coarsest and the finest run side by side, and draws
/// the ends of both into it, with one scale of colours; where that cannot be, it has the reason in their place. Throws
/// RunError where the file cannot be written.
void write_convergence_page(const ConvergenceStudy& study, const std::string& path);

/// "converges", "oscillates"; empty: too few meshes say anything.
std::string verdict_word(const StudyQuantity& quantity);

/// "wall_impulse [N ms]".
std::string named_with_unit(const StudyQuantity& quantity);

/// Value on the scene's own mesh less the extrapolated one; none: it is not among the meshes, or nothing converges.
std::optional<double> own_error(const ConvergenceStudy& study, const StudyQuantity& quantity);

}  // namespace pinball
