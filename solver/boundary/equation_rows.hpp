#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/base/point.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// A node of the store with what its displacement is multiplied by in an equation.
struct EquationPart {
  std::int32_t node = 0;
  Point coefficient{};  ///< factor times direction [-]
};

/// sum of coefficient . u over its parts = 0.
struct EquationRow {
  std::string where;  ///< of its first term, for messages
  std::vector<EquationPart> parts;
};

/// The equations of the scene, one by one: those of one name for each of their nodes. Throws InputError for terms with
/// different numbers of nodes, and for nodes that something else moves as a whole: a rigid body, or a face that they
/// are tied to.
template <class S>
std::vector<EquationRow> equation_rows(const Model<S>& model);

}  // namespace pinball
