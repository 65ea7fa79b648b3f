#include "vtk_values.hpp"

#include <map>

namespace pinball {

std::optional<VtkType> vtk_type(std::string_view name) {
  static const std::map<std::string_view, VtkType> types{
      {"Int8", VtkType::i8},          {"UInt8", VtkType::u8},
      {"Int16", VtkType::i16},        {"UInt16", VtkType::u16},
      {"Int32", VtkType::i32},        {"UInt32", VtkType::u32},
      {"Int64", VtkType::i64},        {"UInt64", VtkType::u64},
      {"Float32", VtkType::f32},      {"Float64", VtkType::f64},
      {"char", VtkType::i8},          {"unsigned_char", VtkType::u8},
      {"short", VtkType::i16},        {"unsigned_short", VtkType::u16},
      {"int", VtkType::i32},          {"unsigned_int", VtkType::u32},
      {"long", VtkType::i64},         {"unsigned_long", VtkType::u64},
      {"vtktypeint64", VtkType::i64}, {"vtktypeuint64", VtkType::u64},
      {"vtkIdType", VtkType::i32},    {"vtkidtype", VtkType::i32},
      {"float", VtkType::f32},        {"double", VtkType::f64},
      {"signed_char", VtkType::i8},   {"vtktypeint32", VtkType::i32},
  };
  const auto found = types.find(name);
  if (found == types.end()) return {};
  return found->second;
}

std::size_t size_of(VtkType type) {
  constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

}  // namespace pinball
