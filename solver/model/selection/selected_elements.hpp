#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// The elements of an initial stress, ascending: those of its numbers, of its set of elements or of its part, or all;
/// of these those of its body all of whose corners lie where it says. Throws InputError that names the table where
/// there is none.
std::vector<std::int32_t> select_elements(const ModelMesh& mesh, const InitialStress& given);

}  // namespace pinball
