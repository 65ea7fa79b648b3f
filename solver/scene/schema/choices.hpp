#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "../../mesh_formats.hpp"
#include "../../scene.hpp"
#include "key.hpp"

/// The names of all choices that a scene has: in files, in Python, in messages.
namespace pinball::schema {

/// A value with its name. Some stand for what is not given: files do not have these.
template <class Value>
struct Choice {
  const char* name;
  Value value;
  bool in_files;

  constexpr Choice(const char* name_, Value value_, bool in_files_ = true)
      : name(name_), value(value_), in_files(in_files_) {}
};

constexpr auto choices(Of<Precision>) {
  using enum Precision;
  return std::array{Choice{pinball::name_of(float64), float64}, Choice{pinball::name_of(float32), float32},
                    Choice{pinball::name_of(mixed), mixed}};
}
constexpr auto choices(Of<Device>) {
  return std::array{Choice{"none", Device::none}, Choice{"mock", Device::mock}, Choice{"cuda", Device::cuda},
                    Choice{"hip", Device::hip}};
}
constexpr auto choices(Of<EquationOfStateForm>) {
  return std::array{Choice{"mie_grueneisen", EquationOfStateForm::mie_grueneisen},
                    Choice{"polynomial", EquationOfStateForm::polynomial},
                    Choice{"tabulated", EquationOfStateForm::tabulated}};
}
constexpr auto choices(Of<VolumeMeasure>) {
  return std::array{Choice{"logarithmic", VolumeMeasure::logarithmic}, Choice{"density", VolumeMeasure::density}};
}
constexpr auto choices(Of<MassScaling>) {
  return std::array{Choice{"small", MassScaling::small}, Choice{"all", MassScaling::all}};
}
constexpr auto choices(Of<HourglassControl>) {
  return std::array{Choice{"none", HourglassControl::none}, Choice{"viscous", HourglassControl::viscous},
                    Choice{"stiffness", HourglassControl::stiffness},
                    Choice{"assumed_strain", HourglassControl::assumed_strain}};
}
constexpr auto choices(Of<NegativeVolume>) {
  return std::array{Choice{"stop", NegativeVolume::stop}, Choice{"erode", NegativeVolume::erode}};
}
constexpr auto choices(Of<InsideOut>) {
  return std::array{Choice{"warn", InsideOut::warn}, Choice{"erode", InsideOut::erode},
                    Choice{"stop", InsideOut::stop}};
}
constexpr auto choices(Of<ContactMethod>) {
  return std::array{Choice{"none", ContactMethod::none}, Choice{"pinball", ContactMethod::pinball},
                    Choice{"slideline", ContactMethod::slideline}, Choice{"not_set", ContactMethod::not_set, false}};
}
constexpr auto choices(Of<Enforcement>) {
  using enum Enforcement;
  return std::array{Choice{enforcement_name(penalty), penalty}, Choice{enforcement_name(projection), projection},
                    Choice{enforcement_name(lagrange), lagrange}};
}
constexpr auto choices(Of<ContactGap>) {
  return std::array{Choice{"pinball", ContactGap::pinball}, Choice{"face", ContactGap::face},
                    Choice{"not_set", ContactGap::not_set, false}};
}
constexpr auto choices(Of<ContactRadius>) {
  return std::array{Choice{"initial", ContactRadius::initial}, Choice{"current", ContactRadius::current}};
}
constexpr auto choices(Of<ContactSearch>) {
  return std::array{Choice{"tree", ContactSearch::tree}, Choice{"hash", ContactSearch::hash},
                    Choice{"automatic", ContactSearch::automatic, false}};
}
constexpr auto choices(Of<ContactOverlap>) {
  return std::array{Choice{"keep", ContactOverlap::keep}, Choice{"adjust", ContactOverlap::adjust}};
}
constexpr auto choices(Of<RateInterpolation>) {
  return std::array{Choice{"linear", RateInterpolation::linear}, Choice{"logarithmic", RateInterpolation::logarithmic}};
}
constexpr auto choices(Of<StrainRate>) {
  return std::array{Choice{"total", StrainRate::total}, Choice{"deviatoric", StrainRate::deviatoric},
                    Choice{"plastic", StrainRate::plastic}};
}
constexpr auto choices(Of<Section>) {
  return std::array{Choice{"full", Section::full}, Choice{"half", Section::half}, Choice{"quarter", Section::quarter},
                    Choice{"wedge", Section::wedge}};
}
constexpr auto choices(Of<ElementShape>) {
  return std::array{Choice{"hexahedra", ElementShape::hexahedra}, Choice{"tetrahedra", ElementShape::tetrahedra}};
}
constexpr auto choices(Of<MeshFormat>) {
  return []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array{Choice{known_mesh_formats[i].name, known_mesh_formats[i].format}...};
  }
  (std::make_index_sequence<known_mesh_formats.size()>{});
}
constexpr auto choices(Of<Frame>) {
  return std::array{Choice{"global", Frame::global}, Choice{"cylindrical", Frame::cylindrical}};
}
constexpr auto choices(Of<MotionQuantity>) {
  return std::array{Choice{"velocity", MotionQuantity::velocity}, Choice{"displacement", MotionQuantity::displacement},
                    Choice{"acceleration", MotionQuantity::acceleration}};
}
constexpr auto choices(Of<JointKind>) {
  return std::array{Choice{"spherical", JointKind::spherical},     Choice{"revolute", JointKind::revolute},
                    Choice{"cylindrical", JointKind::cylindrical}, Choice{"translational", JointKind::translational},
                    Choice{"universal", JointKind::universal},     Choice{"locking", JointKind::locking}};
}
constexpr auto choices(Of<ProbeKind>) {
  return std::array{Choice{"node", ProbeKind::node}, Choice{"element", ProbeKind::element}};
}

template <class Value>
concept HasChoices = requires {
  choices(Of<Value>{});
};

template <HasChoices Value>
constexpr const char* name_of(Value value) {
  for (const auto& choice : choices(Of<Value>{})) {
    if (choice.value == value) return choice.name;
  }
  return "";
}
/// Of a value that a file can give.
template <HasChoices Value>
constexpr bool is_in_files(Value value) {
  for (const auto& choice : choices(Of<Value>{})) {
    if (choice.value == value) return choice.in_files;
  }
  return false;
}

}  // namespace pinball::schema
