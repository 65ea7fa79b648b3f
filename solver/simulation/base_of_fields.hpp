#pragma once

#include <solver/field_base.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Of a mesh that has to live as long.
FieldBase base_of_fields(const ModelMesh& mesh);

}  // namespace pinball
