#pragma once

namespace pinball {

/// Not set, it is decided where the bodies are known: pinball where some can meet, else none.
enum class ContactMethod { none, pinball, slideline, not_set };
enum class Enforcement { penalty, projection, lagrange };
enum class ContactGap { pinball, face, not_set };
enum class ContactRadius { initial, current };
/// How what may touch is found; all find the same.
enum class ContactSearch { automatic, tree, hash };
/// What becomes of nodes that lie in another body at the start.
enum class ContactOverlap { keep, adjust };

/// As in the scene and in summary.json.
constexpr const char* enforcement_name(Enforcement enforcement) {
  return enforcement == Enforcement::penalty      ? "penalty"
         : enforcement == Enforcement::projection ? "projection"
                                                  : "lagrange";
}

/// Largest contact.radius_factor and contact.skin: with these each element has all within ten elements in its list, and
/// lists grow with the third power.
inline constexpr double largest_radius_factor = 10, largest_skin = 10;

/// What can be chosen about contact, with its keys in a scene.
struct ContactSettings {
  /// contact.method = "none" | "pinball" | "slideline"; not set, it becomes pinball where bodies can meet, else none
  ContactMethod method = ContactMethod::not_set;
  Enforcement enforcement = Enforcement::lagrange;  ///< contact.enforcement = "penalty" | "projection" | "lagrange"
  /// contact.gap = "pinball" | "face"; not set, it becomes pinball (penalty) or face
  ContactGap gap = ContactGap::not_set;
  double beta = 1.0;              ///< contact.beta: penalty factor of report eq. (3.11) [-]
  double damping = 0.1;           ///< contact.damping: fraction xi of critical damping, p1 = 2 xi sqrt(p2 m) [-]
  double friction = 0.0;          ///< contact.friction: Coulomb coefficient while sliding [-]
  double static_friction = -1.0;  ///< contact.static_friction: at rest; negative: not set, becomes friction [-]
  /// contact.friction_decay: with it friction is mu + (mu_s - mu) exp(-decay |v|) of the sliding velocity v; 0: that at
  /// rest or that of sliding [time/length]
  double friction_decay = 0.0;
  ContactRadius radius = ContactRadius::initial;    ///< contact.radius = "initial" | "current"
  double radius_factor = 1.0;                       ///< contact.radius_factor: on the radius of (3.2) [-]
  bool self = true;                                 ///< contact.self: a body may touch itself
  ContactSearch search = ContactSearch::automatic;  ///< contact.search = "tree" | "hash"; not set: what suits the scene
  /// contact.overlap = "keep" | "adjust": nodes that lie in another body at the start come no deeper, or are put on its
  /// surface, without stress
  ContactOverlap overlap = ContactOverlap::keep;
  double skin = 0.5;  ///< contact.skin: scale of what a node may stray before lists are built anew, over its radius [-]
};

}  // namespace pinball
