#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "abaqus_data.hpp"

namespace pinball {

/// How much of one thing another one has.
enum class Share { none, some, all };

/// Which faces of each body a surface holds.
struct AbaqusFaces {
  std::vector<std::vector<std::int64_t>> of_body;  ///< per body, ascending: element * 6 + face; of nodes: one entry, -1
  std::vector<bool> whole;                         ///< per body: all that is outside
  bool of_nodes = false;
};

/// How much of what `faces` has of a body `other` has, too. Of nodes it is known for whole bodies alone.
Share share_of(const AbaqusFaces& faces, const AbaqusFaces& other, std::size_t body);

/// Surfaces of a deck by the outsides of its bodies.
class AbaqusOutside {
 public:
  /// data has to stay.
  explicit AbaqusOutside(const AbaqusData& data);
  /// Of a surface; of all bodies for an empty label. Throws InputError where it is not there.
  const AbaqusFaces& faces(const std::string& label, const DeckPlace& place);

 private:
  void find_outside();
  AbaqusFaces of_faces(const FaceSet& set) const;
  AbaqusFaces of_nodes(const std::vector<std::int32_t>& nodes) const;
  AbaqusFaces complete(AbaqusFaces faces) const;

  const AbaqusData& data_;
  std::vector<std::int32_t> body_of_part_;  ///< -1: a section without elements
  AbaqusFaces outside_;
  std::map<std::string, AbaqusFaces> known_;
};

}  // namespace pinball
