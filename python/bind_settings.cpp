#include "bind_keys.hpp"

namespace pinball::python {

void bind_settings(py::module_& module) {
  bind_choice<Precision>(module, "Precision");
  bind_choice<Device>(module, "Device");
  bind_choice<HourglassControl>(module, "HourglassControl");
  bind_choice<ContactMethod>(module, "ContactMethod");
  bind_choice<Enforcement>(module, "Enforcement");
  bind_choice<ContactGap>(module, "ContactGap");
  bind_choice<ContactRadius>(module, "ContactRadius");
  bind_choice<ContactSearch>(module, "ContactSearch");
  bind_choice<ContactOverlap>(module, "ContactOverlap");
  bind_choice<ElementShape>(module, "ElementShape");
  bind_choice<NegativeVolume>(module, "NegativeVolume");
  bind_choice<InsideOut>(module, "InsideOut");
  bind_choice<StrainRate>(module, "StrainRate");
  bind_choice<RateInterpolation>(module, "RateInterpolation");
  bind_choice<EquationOfStateForm>(module, "EquationOfStateForm");
  bind_choice<VolumeMeasure>(module, "VolumeMeasure");
  bind_choice<MassScaling>(module, "MassScaling");
  bind_table<TimeSettings>(module, "TimeSettings", "[time] of a scene");
  bind_table<ElementSettings>(module, "ElementSettings", "[element] of a scene");
  bind_table<ContactSettings>(module, "ContactSettings", "[contact] of a scene");
  bind_table<SkipSettings>(module, "SkipSettings", "[skip] of a scene");
  bind_table<GuardSettings>(module, "GuardSettings", "[guard] of a scene");
  bind_table<OutputSettings>(module, "OutputSettings", "[output] of a scene, for run_recorded()");
}

}  // namespace pinball::python
