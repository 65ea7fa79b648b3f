#pragma once

#include <string>
#include <vector>

#include "../../scene.hpp"
#include "key.hpp"

/// The keys of contact.
namespace pinball::schema {

/// Where keys of contact say nothing, but for all of them where contact is off.
constexpr bool slideline(const ContactSettings& contact, const Scene&) {
  return contact.method == ContactMethod::slideline;
}
constexpr bool impulses(const ContactSettings& contact, const Scene&) {
  return contact.enforcement != Enforcement::penalty;
}
constexpr bool no_balls(const ContactSettings& contact, const Scene&) {
  return contact.method == ContactMethod::slideline || contact.gap == ContactGap::face;
}
constexpr bool one_friction(const ContactSettings& contact, const Scene&) {
  return contact.static_friction == contact.friction;
}
inline bool pairs_have_friction(const ContactSettings& contact, const Scene& scene) {
  for (const ContactPair& pair : scene.contact_pairs) {
    if (pair.friction == contact.friction) return false;
  }
  return !scene.contact_pairs.empty();
}

template <class Visit>
constexpr void describe(Of<ContactSettings>, Visit&& visit) {
  using T = ContactSettings;
  visit(Key{"method",
            &T::method,
            "`\"none\"`; `\"pinball\"`; or `\"slideline\"`, which pinballs replaced: nodes of the surface against "
            "faces, in both directions",
            {.otherwise = "pinball where bodies can meet"}});
  visit(Key{"enforcement", &T::enforcement,
            "`\"penalty\"`: springs between pinballs, as in the report; `\"lagrange\"`: the impulses that let no gap "
            "close within the step, from the coupled system of all pairs; `\"projection\"`: one step towards the "
            "same. The last two leave the time step alone and have no parameters but friction"});
  visit(Key{"gap",
            &T::gap,
            "what the gap is measured between: `\"pinball\"`: the balls, which reach 0.12 h out of flat faces; "
            "`\"face\"`: nodes against faces in both directions and edges against edges, where they are; not for "
            "penalty in this version. A slideline measures from node to face whatever stands here. Balls see what "
            "near-cubes of one size do: for others a warning at the start says what to choose",
            {.otherwise = "`\"pinball\"` for penalty, else `\"face\"`"}}
            .idle_where(slideline, "beside method = \"slideline\""));
  visit(Key{"beta",
            &T::beta,
            "penalty factor of the report's equation (3.11); above 2 the contact can limit the time step. Of a "
            "slideline: factor of K A^2/V, half in each direction; limits the time step from 0.1 on",
            {.unit = "-", .bound = not_negative}}
            .idle_where(impulses, "where enforcement is not \"penalty\""));
  visit(Key{"damping",
            &T::damping,
            "fraction xi of critical damping, p1 = 2 xi sqrt(p2 m)",
            {.unit = "-", .bound = not_negative}}
            .idle_where(impulses, "where enforcement is not \"penalty\""));
  visit(Key{"friction",
            &T::friction,
            "Coulomb coefficient while sliding; not with penalty, and not between balls, which touch elsewhere than "
            "elements do. What friction takes is part of the contact energy",
            {.unit = "-", .bound = not_negative}}
            .idle_where(pairs_have_friction, "where each contact.pair has its own"));
  visit(Key{"static_friction",
            &T::static_friction,
            "the same at rest, >= `friction`; another value than `friction` only with lagrange",
            {.unit = "-", .bound = not_negative, .unset = Unset::negative, .otherwise = "as friction"}});
  visit(Key{"friction_decay",
            &T::friction_decay,
            "> 0: the coefficient is `friction + (static_friction - friction) exp(-friction_decay v)` of the sliding "
            "velocity v of the step before; 0: that at rest or that of sliding. FS, FD and DC of LS-DYNA are "
            "`static_friction`, `friction` and this",
            {.unit = "T/L", .bound = not_negative}}
            .idle_where(one_friction, "where static_friction is friction"));
  visit(Key{"radius", &T::radius, "pinballs: radius from the `\"initial\"` or the `\"current\"` volume of the element"}
            .idle_where(no_balls, "where no balls touch, but faces: gap = \"face\" or method = \"slideline\""));
  visit(Key{"radius_factor",
            &T::radius_factor,
            "on that radius; 0.806 = (pi/6)^(1/3): the ball of a cube just reaches its faces",
            {.unit = "-", .bound = {.low = 0.0, .low_open = true, .high = largest_radius_factor}}}
            .idle_where(no_balls, "where no balls touch, but faces: gap = \"face\" or method = \"slideline\""));
  visit(Key{"self", &T::self, "a body may touch itself"});
  visit(Key{"search",
            &T::search,
            "how what may touch is found, with the same results: `\"tree\"`, boxes over boxes of elements with near "
            "numbers; `\"hash\"`, cells of grids for each size. What suits is measured when lists are made. A "
            "slideline always takes a tree",
            {.otherwise = "what suits the scene"}}
            .idle_where(slideline, "beside method = \"slideline\""));
  visit(Key{
      "overlap", &T::overlap,
      "what becomes of nodes that lie in another body at the start, which are reported with their depth: `\"keep\"`: "
      "they come no deeper, without stress, and what is deeper than about a quarter of an element passes; "
      "`\"adjust\"`: they are put on the surface of the other body, without stress, half of the way done by each "
      "of two bodies where nodes of both lie inside; nodes that are held or tied stay"});
  visit(Key{"skin",
            &T::skin,
            "how far a node may stray from its straight way before what may touch is searched anew: scale over the "
            "radius of its pinballs or the size of its faces",
            {.unit = "-", .bound = {.low = 0.0, .high = largest_skin}}}
            .idle_where([](const T&, const Scene& scene) { return !scene.skip.contact_search; },
                        "beside skip.contact_search = false"));
  visit(FileKey<std::vector<ContactPair>>{
      "pair", "`[[contact.pair]]`: what may touch what, see below", {.otherwise = "all touches all"}});
  visit(FileKey<std::vector<TiedContact>>{
      "tied", "`[[contact.tied]]`: nodes that move with faces, see below", {.otherwise = "none"}});
}

/// { elements = "SET" }, { faces = "SET" } or { nodes = "SET" }: what a side of a contact has beside names of bodies.
struct SideOfSet {};

template <class Visit>
constexpr void describe(Of<SideOfSet>, Visit&& visit) {
  visit(FileKey<std::string>{"elements", "a set of elements: their surface, also what erosion uncovers of it"});
  visit(FileKey<std::string>{"faces", "a set of faces"});
  visit(FileKey<std::string>{"nodes", "a set of nodes, alone"});
  visit(FileKey<std::string>{"file", "the mesh file that has the set, where there are several"});
}

template <class Visit>
constexpr void describe(Of<ContactPair>, Visit&& visit) {
  using T = ContactPair;
  visit(Key{"name",
            &T::name,
            "unique; of the columns in `history.csv`, counted from 0",
            {.form = Form::name, .otherwise = "pair_NUMBER", .listed = Listed::never}});
  visit(Key{"first",
            &T::first,
            "a body, a set, or an array of these (below): all of them together",
            {.need = Need::required, .done = Done::reading_by_hand}});
  visit(Key{"second",
            &T::second,
            "the same; without it the members of `first` touch each other, and themselves",
            {.otherwise = "first", .done = Done::reading_by_hand}});
  visit(Key{"friction",
            &T::friction,
            "as in `[contact]`; where one of these three is given, none is taken from `[contact]`",
            {.unit = "-", .bound = not_negative, .unset = Unset::negative, .otherwise = "of `[contact]`"}});
  visit(Key{"static_friction",
            &T::static_friction,
            "as in `[contact]`",
            {.unit = "-", .bound = not_negative, .unset = Unset::negative, .otherwise = "as friction"}});
  visit(Key{"friction_decay",
            &T::friction_decay,
            "as in `[contact]`",
            {.unit = "T/L", .bound = not_negative, .unset = Unset::negative, .otherwise = "0"}}
            .idle_where([](const T& pair,
                           const Scene&) { return pair.friction_decay > 0 && pair.static_friction == pair.friction; },
                        "where static_friction is friction"));
  visit(Key{"start", &T::start, "they may touch from the steps of `start` on", {.unit = "T"}});
  visit(Key{"end", &T::end, "and before it", {.unit = "T", .unset = Unset::infinite, .otherwise = "none"}});
  visit(Field{"where", &T::where, "for messages"});
}

template <class Visit>
constexpr void describe(Of<TiedContact>, Visit&& visit) {
  using T = TiedContact;
  visit(Key{"name", &T::name, "unique", {.form = Form::name, .otherwise = "tied_NUMBER", .listed = Listed::never}});
  visit(Key{"first",
            &T::first,
            "as in `[[contact.pair]]`: whose nodes are tied; should have the finer mesh",
            {.need = Need::required, .done = Done::reading_by_hand}});
  visit(Key{"second",
            &T::second,
            "whose faces they are tied to; no sets of nodes",
            {.need = Need::required, .done = Done::reading_by_hand}});
  visit(Key{"tolerance",
            &T::tolerance,
            "how far from a face a node may lie",
            {.unit = "L",
             .bound = not_negative,
             .unset = Unset::negative,
             .otherwise = "0.05 of a face's shorter diagonal"}});
  visit(Key{"start", &T::start, "they are tied from the steps of `start` on", {.unit = "T"}});
  visit(Key{"end", &T::end, "and before it", {.unit = "T", .unset = Unset::infinite, .otherwise = "none"}});
  visit(Field{"where", &T::where, "for messages"});
}

}  // namespace pinball::schema
