#pragma once

#include <optional>
#include <string>
#include <vector>

#include "abaqus_outside.hpp"

namespace pinball {

/// The sides of a contact pair; an empty second one: the first touches itself.
struct AbaqusSides {
  DeckSide first{}, second{};
  bool operator==(const AbaqusSides&) const = default;
};

/// *CONTACT EXCLUSIONS, and what pairs of general contact are without them. A surface is left out of a pair where it
/// holds all that the pair has of a body: a part of that is no side that a scene knows, and is refused.
class AbaqusExclusions {
 public:
  /// data has to stay.
  explicit AbaqusExclusions(AbaqusData& data) : data_(data) {}

  void read(const AbaqusBlock& block);
  void add(const DeckPlace& place, const std::string& first, const std::string& second);
  /// How much of a pair of surfaces these pairs have, none of which is asked to be left out: also for pairs that are
  /// included.
  Share share_of_pair(const std::string& first, const std::string& second, const DeckPlace& place);
  /// A pair of surfaces as it is; of an empty label all bodies. A second one that is empty, or the first: it touches
  /// itself. Throws InputError for surfaces that are not there.
  AbaqusSides all_of(const std::string& first, const std::string& second, const DeckPlace& place) const;
  /// What is left of it.
  std::vector<AbaqusSides> left_of(const std::string& first, const std::string& second, const DeckPlace& place);
  /// Tells which of them have left out nothing.
  void report_idle() const;

 private:
  struct Exclusion {
    DeckPlace place;
    std::string first, second;  ///< labels, as those of a pair
    bool idle = true;
  };
  /// A surface with the bodies that it has faces of.
  struct Side {
    const AbaqusFaces* faces;
    std::vector<std::size_t> bodies;
    DeckSide whole;
  };
  /// Per body of one side and of the other.
  using Table = std::vector<std::vector<Share>>;

  DeckSide side_of(const std::string& label, const DeckPlace& place) const;
  Side side(const std::string& label, const DeckPlace& place);
  /// How much of what two sides have of their bodies is left out.
  Table left_out(const Side& first, const Side& second);
  void leave_out(Exclusion& exclusion, const Side& first, const Side& second, Table& out);
  std::vector<AbaqusSides> among(const Side& side, const Table& out);
  std::vector<AbaqusSides> between(const Side& first, const Side& second, const Table& out);
  /// Some of the bodies of a side, by their places among them.
  DeckSide part_of(const Side& side, const std::vector<std::size_t>& places);
  void reject(const Exclusion& exclusion);

  AbaqusData& data_;
  std::vector<Exclusion> exclusions_;
  std::optional<AbaqusOutside> outside_;  ///< only where there are any
  /// The last ones that took a part of what a pair has of two bodies, and all of it.
  const Exclusion *partial_ = nullptr, *whole_ = nullptr;
};

}  // namespace pinball
