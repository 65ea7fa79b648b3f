#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <solver/base/point.hpp>
#include <solver/keyword/fields.hpp>
#include <solver/keyword/keyword_deck.hpp>
#include <solver/mesh/mesh_file.hpp>

#include "deck_report.hpp"

namespace pinball {

struct DeckPart {
  std::int64_t id, section, material, hourglass;
  std::string body;  ///< name of the body that it becomes
  DeckPlace place;
};

struct DeckHourglass {
  std::int64_t form = 1;     ///< IHQ
  double coefficient = 0.1;  ///< QH, QM
};

struct DeckCurve {
  std::vector<double> abscissa, ordinate;
};

/// What keywords of a deck refer to by number, read before anything that refers to it.
class DeckData {
 public:
  /// deck, mesh and report have to stay.
  DeckData(const KeywordDeck& deck, const MeshFile& mesh, DeckReport& report);

  const KeywordDeck& deck;
  const MeshFile& mesh;
  DeckReport& report;

  std::vector<DeckPart> parts;  ///< those with solids, in the order of the deck
  std::map<std::int64_t, std::int64_t> section_form;
  std::map<std::int64_t, DeckHourglass> hourglass;
  std::vector<bool> used;  ///< per node of the mesh: whether a solid of a part has it

  const DeckCurve& curve(std::int64_t id, const DeckPlace& place) const;
  bool is_curve(std::int64_t id) const { return curves_.contains(id); }
  /// Pairs of a rate and the curve for it.
  const std::vector<std::pair<double, std::int64_t>>* table(std::int64_t id) const;
  /// Unit vector of *DEFINE_VECTOR.
  Point vector(std::int64_t id, const DeckPlace& place) const;
  /// Unit vectors of a local system; those of the global one for 0.
  std::array<Point, 3> axes(std::int64_t system, const DeckPlace& place) const;
  /// Numbers of parts; those of set 0 and of numbers without parts are an error.
  std::vector<std::int64_t> part_set(std::int64_t id, const DeckPlace& place) const;
  /// Body of a part. Throws InputError for a number without a part; none: a part without solids.
  std::optional<std::string> body_of(std::int64_t part, const DeckPlace& place) const;

  Fields fields(const Card& card) const { return Fields(card, deck.parameters); }

 private:
  void read_parts(const KeywordBlock& block);
  void read_section(const KeywordBlock& block);
  void read_hourglass(const KeywordBlock& block);
  void read_curve(const KeywordBlock& block);
  void read_table(const KeywordBlock& block);
  void read_vector(const KeywordBlock& block);
  void read_system(const KeywordBlock& block);
  void read_part_set(const KeywordBlock& block);
  void name_bodies();

  std::map<std::int64_t, DeckCurve> curves_;
  std::map<std::int64_t, std::vector<std::pair<double, std::int64_t>>> tables_;
  std::map<std::int64_t, Point> vectors_;
  std::map<std::int64_t, std::array<Point, 3>> systems_;
  std::map<std::int64_t, std::vector<std::int64_t>> part_sets_;
  std::map<std::int64_t, std::string> titles_;
  std::vector<DeckPart> all_parts_;
};

/// offset: of *INCLUDE_TRANSFORM, for numbers of that kind.
std::int64_t offset_of(const KeywordBlock& block, std::int64_t DeckTransform::*which);

}  // namespace pinball
