#pragma once

#include <string>

#include <solver/program/study/convergence_study.hpp>

/// What a study has said of a scene's numbers, in a file beside the scene, for the runs that follow.
namespace pinball {

/// "folder/scene.converged.json" of "folder/scene.toml".
std::string kept_bands_path(const std::string& scene_path);

/// {scene, version, settings, quantities [{name, unit, value, extrapolated, low, high, verdict}]}: of each quantity
/// with a band what the scene's own mesh says, and where the answer of finer ones is expected. settings: a hash of all
/// keys, mesh files, version and device, by which a run is known to be the one that the band is of. scene: on its own
/// mesh.
std::string kept_bands_json(const ConvergenceStudy& study, const Scene& scene);

/// The quantities of such a file, for summary and page of a run of this scene; empty: there is no file. Where it is of
/// other settings, or cannot be read, empty as well, and `note` says so.
std::string kept_bands_of(const std::string& scene_path, const Scene& scene, std::string& note);

/// A line for each of these quantities: "tip_displacement_y [m]: 0.00100421, finer meshes 0.000996 .. 0.001027".
std::string kept_bands_text(const std::string& quantities);

}  // namespace pinball
