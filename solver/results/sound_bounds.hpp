#pragma once

/// From where on a run is hardly to be believed: what warnings() says, and from when on.
namespace pinball::sound {

/// Error of the energy balance, of the energy in motion [-].
inline constexpr double balance = 0.1;
/// Penetration over the sum of the two radii of what springs hold apart, and of balls, which reach out of flat faces
/// [-].
inline constexpr double penetration = 0.25;
/// The same of faces that impulses hold apart: they let nothing in that they see coming [-].
inline constexpr double penetration_of_faces = 0.05;
/// Depth at which bodies are in each other at the end, over the size of an element: what search has not found shows in
/// no penetration [-].
inline constexpr double depth_at_end = 0.2;
/// Depth of a node in another body at the start, over the size of an element, up to which contact between faces holds
/// it where it is: what is deeper passes [-].
inline constexpr double overlap_held = 0.25;
/// The same where contact begins later [-].
inline constexpr double late_overlap_held = 0.15;
/// Energy that contact has brought in, of the energy in motion [-].
inline constexpr double contact_created = 0.01;
/// Energy that contact has taken out of bodies that cannot but keep it, of the energy in motion. Where coarse meshes
/// meet face to face it takes up to this, less with each refinement: blocks of three and four elements lose 12 to 19 %
/// [-].
inline constexpr double contact_swallowed = 0.2;
/// Steps with contact whose impulses did not converge, of all of them [-].
inline constexpr double unconverged = 0.03;
/// Nodes of a tie's second side that lie on its first side with nothing that follows them, over those tied [-].
inline constexpr double open_tie = 0.25;
/// Hourglass energy, of the largest internal energy [-].
inline constexpr double hourglass = 0.1;
/// Plastic work of hourglass modes, of the same. Where one layer of elements bends it is most of all plastic work [-].
inline constexpr double hourglass_plastic = 0.5;
/// Hourglass energy below zero, of the same [-].
inline constexpr double hourglass_created = 0.01;
/// Least internal energy, of the energy in motion, that hourglass energy is compared with: a tenth of less is nothing
/// that a result depends on, and a body at rest has none but round-off [-].
inline constexpr double least_internal = 0.01;
/// Kinetic energy below zero, of the energy in motion. What vibrates in all modes shows a quarter, with a balance that
/// holds; more means that what carries the energy turns round within a step [-].
inline constexpr double kinetic_below_zero = 0.3;
/// Internal energy below zero, of the same [-].
inline constexpr double internal_below_zero = 0.01;
/// Mass that is added to a body, and taken from it, for time.smallest_step, over that of its material [-].
inline constexpr double added_mass = 0.05;

}  // namespace pinball::sound
