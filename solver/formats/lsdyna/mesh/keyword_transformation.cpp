#include "keyword_transformation.hpp"

#include <fmt/format.h>

#include <cmath>

#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>

namespace pinball {

namespace {

Transformation scaling(const Fields& fields) {
  Transformation t;
  for (std::size_t k = 0; k < 3; ++k) {
    const double factor = fields.number(k + 1);
    t.rows[k][k] = factor == 0 ? 1.0 : factor;
  }
  return t;
}

Transformation translation(const Fields& fields) {
  Transformation t;
  for (std::size_t k = 0; k < 3; ++k) t.shift[k] = fields.number(k + 1);
  return t;
}

Point unit(Point d, const DeckPlace& place) {
  const double length = std::sqrt(dot(d, d));
  if (!(length > 0)) fail_at(place, "*DEFINE_TRANSFORMATION: expected a direction, got a vector of no length");
  for (double& component : d) component /= length;
  return d;
}

/// A x with A = c I + (1 - c) a a^T + s [a]x (Rodrigues), about the axis a through a point.
Transformation rotation(const Fields& fields) {
  if (fields.number("A4") == 0 && fields.number("A5") == 0 && fields.number("A6") == 0 && fields.number("A7") == 0 &&
      fields.number("A3") != 0 && fields.number("A1") >= 1)
    fail_at(fields.place(),
            "*DEFINE_TRANSFORMATION: ROTATE about two nodes or points is not read; expected axis, point and angle");
  const Point axis = unit(fields.point("A1"), fields.place());
  const Point through = fields.point("A4");
  const double angle = fields.number("A7") * std::acos(-1.0) / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  Transformation t;
  for (std::size_t k = 0; k < 3; ++k) {
    Point e{};
    e[k] = 1;
    const Point turned = cross(axis, e);
    for (std::size_t i = 0; i < 3; ++i) t.rows[i][k] = c * e[i] + (1 - c) * axis[i] * axis[k] + s * turned[i];
  }
  const Point moved = t.apply(through);
  t.shift = minus(through, moved);
  return t;
}

/// At the plane through the first point, normal to the way to the second.
Transformation mirroring(const Fields& fields) {
  const Point tail = fields.point("A1"), head = fields.point("A4");
  const Point normal = unit(minus(head, tail), fields.place());
  Transformation t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) t.rows[i][k] -= 2 * normal[i] * normal[k];
  }
  t.shift = minus(tail, t.apply(tail));
  return t;
}

Transformation one_of(const Fields& fields) {
  const std::string option = upper_case(fields.text("OPTION"));
  if (option == "TRANSL") return translation(fields);
  if (option == "SCALE") return scaling(fields);
  if (option == "ROTATE") return rotation(fields);
  if (option == "MIRROR") return mirroring(fields);
  fail_at(fields.place(),
          fmt::format("*DEFINE_TRANSFORMATION: expected TRANSL, SCALE, ROTATE or MIRROR, got \"{}\"", option));
}

}  // namespace

Point Transformation::apply(const Point& x) const {
  Point result = shift;
  for (std::size_t i = 0; i < 3; ++i) result[i] += dot(rows[i], x);
  return result;
}

void Transformation::then(const Transformation& other) {
  Transformation both;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      both.rows[i][k] = 0;
      for (std::size_t j = 0; j < 3; ++j) both.rows[i][k] += other.rows[i][j] * rows[j][k];
    }
  }
  both.shift = other.apply(shift);
  *this = both;
}

Transformations::Transformations(const KeywordDeck& deck) {
  GivenOnce given;
  for (const KeywordBlock& block : deck.blocks) {
    if (block.name != "DEFINE_TRANSFORMATION") continue;
    if (!units_of(block).are_own())
      fail_at(block.place, "*DEFINE_TRANSFORMATION in an included file of other units is not read");
    Cards cards(block);
    if (block.title) cards.next();
    const std::int64_t number =
        Fields(cards.require("its number"), deck.parameters, layout::transformation).integer("TRANID");
    Transformation whole;
    while (const auto card = cards.next_filled())
      whole.then(one_of(Fields(*card, deck.parameters, layout::transformation_step)));
    given.add(fmt::format("transformation {}", number + (block.transform ? block.transform->define : 0)), block.place,
              block.of_case);
    by_number_[number + (block.transform ? block.transform->define : 0)] = whole;
  }
}

const Transformation* Transformations::of(const KeywordBlock& block) const {
  if (!block.transform || block.transform->transformation == 0) return nullptr;
  const auto found = by_number_.find(block.transform->transformation);
  if (found == by_number_.end())
    fail_at(block.place, fmt::format("*INCLUDE_TRANSFORM: no *DEFINE_TRANSFORMATION has the number {}",
                                     block.transform->transformation));
  return &found->second;
}

}  // namespace pinball
