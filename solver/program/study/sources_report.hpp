#pragma once

#include <optional>
#include <string>

#include "convergence_study.hpp"

/// What a study shows of the sources of error beside the mesh.
namespace pinball {

/// What the mesh of the sources may err by: as far as the farther end of the band is from its value; where nothing
/// converges the spread. None: too few meshes have a value.
std::optional<double> error_of_mesh(const ConvergenceStudy& study, const StudyQuantity& quantity);

/// What mesh, time step, precision where the other is the better one, the worst of the other hourglass controls, that
/// of the other kinds of contact, and twice the deviation by chance move it by, added up as numerical uncertainties are
/// by Oberkampf and Roy (2010, section 8.7): the value of the mesh of the sources less and plus this is the answer with
/// its error bar. None: the mesh says nothing, or the values on meshes do not converge.
std::optional<double> error_together(const ConvergenceStudy& study, const StudyQuantity& quantity);

/// "mesh" or the name of a source, of the largest; empty: nothing moves the quantity by more than 1e-6 of its scale.
std::string largest_source(const ConvergenceStudy& study, const StudyQuantity& quantity);

/// "refine plate, not rod": where refining one of several bodies moves the quantity more than twice as much as refining
/// any other; "refine plate and rod" where not; empty: fewer than two were refined apart.
std::string body_to_refine(const ConvergenceStudy& study, const StudyQuantity& quantity);

/// Whether the deviation of the ensemble is larger than the error of the mesh.
bool chance_rules(const ConvergenceStudy& study, const StudyQuantity& quantity);

/// A line for each quantity, what the columns are, and the quantities where chance is more than the mesh; empty: there
/// are no sources.
std::string sources_text(const ConvergenceStudy& study);

/// "the largest source of error is the mesh for 3 of them, chance for 1"; empty: there are no sources.
std::string sources_sentence(const ConvergenceStudy& study);

}  // namespace pinball
