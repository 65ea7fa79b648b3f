#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model.hpp"

namespace pinball {

/// Two bodies that share space.
struct InitialOverlap {
  std::string first, second;  ///< names of the bodies; empty: no bodies do
  /// Nodes, and nine points of each element, that lie inside an element of the other body; without any: edges of the
  /// surface of one that go through the other.
  std::int64_t points = 0;
  std::int64_t nodes = 0;  ///< of both that lie deeper in the other body than the facets of curved surfaces explain
  std::int32_t node = -1;  ///< the deepest of them, in the order of the scene; negative: there is none
  double depth = 0;        ///< its distance to the surface of the other body [length]
  double share = 0;        ///< the same over the size of the face there [-]
  double time = 0;         ///< when contact between them begins [time]
};

/// The first two bodies that overlap, by default more than rounding and curved surfaces of touching meshes do: a node
/// or a point of an element lies inside an element of the other body, at least `depth` deep over the size of that
/// [-], or an edge goes through the other body. Contact cannot tell from which side such bodies came. pairs: of the
/// scene; where there are any, only bodies that these let touch are looked at. rigid: as of OverlappingBodies. Of nodes
/// and depths nothing is said.
InitialOverlap find_initial_overlap(const ModelMesh& mesh, const std::vector<ContactPair>& pairs = {},
                                    double depth = 0.1, const std::vector<std::int32_t>& rigid = {});

/// The same of bodies that may touch at a time: those whose contact pairs have ended before share space as the scene
/// asks.
InitialOverlap find_overlap_at(double time, const Scene& scene, const ModelMesh& mesh, double depth);

/// All bodies that overlap, two by two in the order of the scene: with points more than a tenth of an element inside,
/// or with nodes more than a hundredth of a face. A node inside is known from the facets that a curved surface is made
/// of: how far these stand out of the surface follows from the angles between them.
std::vector<InitialOverlap> find_initial_overlaps(const Scene& scene, const ModelMesh& mesh);

/// The same of bodies whose contact begins later: by pairs that begin after `before`, and not after `time`. mesh: as it
/// is at that time.
std::vector<InitialOverlap> find_begun_overlaps(const Scene& scene, const ModelMesh& mesh, double before, double time);

/// contact.overlap = "adjust": puts the nodes that lie inside another body on its surface, each of two bodies by its
/// share, without stress: before volumes and masses are known. Nodes that are held in all directions, or tied, stay,
/// those on planes of symmetry stay on these. Throws InputError where an element would have no volume.
void adjust_initial_overlaps(const Scene& scene, const std::vector<TiedNode>& ties, ModelMesh& mesh);

}  // namespace pinball
