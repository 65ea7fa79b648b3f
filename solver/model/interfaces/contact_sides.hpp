#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <solver/contact/surface/contact_pairs.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// The contact pairs of a scene, its ties and what is attached to rigid bodies, as contact sees them; null where there
/// are none. Throws InputError for a set that is not there, or that holds nothing of the scene's bodies.
template <class S>
std::unique_ptr<ContactPairs> make_contact_pairs(const Model<S>& model);

/// Which nodes and faces a side of the scene holds; in the numbers of the scene.
struct SideMembers {
  std::vector<std::uint8_t> body;                  ///< per body: all of it
  std::vector<std::int32_t> elements;              ///< of sets
  std::vector<std::array<std::int32_t, 4>> faces;  ///< of sets, by their nodes
  std::vector<std::int32_t> nodes;                 ///< of sets
};
/// where: for messages. Throws InputError for sets that are not there.
SideMembers find_members(const ModelMesh& mesh, const ContactSide& side, const std::string& where);

/// Which nodes each tied contact of a scene, and each contact pair of two sides, has on its first and on its second
/// side, near each other or not; in the numbers of the scene. Throws InputError for sets that are not there.
class MetSides {
 public:
  MetSides(const Scene& scene, const ModelMesh& mesh);
  /// Whether one of them has one of two nodes on the one side and the other on the other one.
  bool have(std::int32_t a, std::int32_t b) const;

 private:
  std::vector<std::array<std::vector<bool>, 2>> nodes_;  ///< per contact and side: per node
};

}  // namespace pinball
