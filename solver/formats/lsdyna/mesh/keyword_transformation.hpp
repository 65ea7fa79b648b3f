#pragma once

#include <array>
#include <cstdint>
#include <map>

#include <solver/base/point.hpp>
#include <solver/formats/lsdyna/scan/keyword_deck.hpp>

namespace pinball {

/// x -> A x + b.
struct Transformation {
  std::array<Point, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Point shift{};

  Point apply(const Point& x) const;
  double determinant() const { return dot(rows[0], cross(rows[1], rows[2])); }  ///< negative: it mirrors
  /// This one first, and then the other.
  void then(const Transformation& other);
};

/// All *DEFINE_TRANSFORMATION of a deck: TRANSL, SCALE, ROTATE about an axis through a point, MIRROR; applied in the
/// order of their cards.
class Transformations {
 public:
  explicit Transformations(const KeywordDeck& deck);

  /// That of the included file that a block stands in; none: null. Throws InputError where it is not defined.
  const Transformation* of(const KeywordBlock& block) const;

 private:
  std::map<std::int64_t, Transformation> by_number_;
};

}  // namespace pinball
