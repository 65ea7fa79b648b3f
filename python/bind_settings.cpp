#include "bindings.hpp"

namespace pinball::python {

void bind_settings(py::module_& module) {
  bind_choice<Precision>(module, "Precision", {{"float", Precision::float32}, {"double", Precision::float64}});
  bind_choice<Device>(module, "Device",
                      {{"none", Device::none}, {"mock", Device::mock}, {"cuda", Device::cuda}, {"hip", Device::hip}});
  bind_choice<HourglassControl>(module, "HourglassControl",
                                {{"none", HourglassControl::none},
                                 {"viscous", HourglassControl::viscous},
                                 {"stiffness", HourglassControl::stiffness},
                                 {"assumed_strain", HourglassControl::assumed_strain}});
  bind_choice<ContactMethod>(module, "ContactMethod",
                             {{"none", ContactMethod::none},
                              {"pinball", ContactMethod::pinball},
                              {"slideline", ContactMethod::slideline},
                              {"not_set", ContactMethod::not_set}});
  bind_choice<Enforcement>(module, "Enforcement",
                           {{"penalty", Enforcement::penalty},
                            {"projection", Enforcement::projection},
                            {"lagrange", Enforcement::lagrange}});
  bind_choice<ContactGap>(
      module, "ContactGap",
      {{"pinball", ContactGap::pinball}, {"face", ContactGap::face}, {"not_set", ContactGap::not_set}});
  bind_choice<ContactRadius>(module, "ContactRadius",
                             {{"initial", ContactRadius::initial}, {"current", ContactRadius::current}});
  bind_choice<ContactSearch>(
      module, "ContactSearch",
      {{"automatic", ContactSearch::automatic}, {"tree", ContactSearch::tree}, {"hash", ContactSearch::hash}});
  bind_choice<ContactOverlap>(module, "ContactOverlap",
                              {{"keep", ContactOverlap::keep}, {"adjust", ContactOverlap::adjust}});
  bind_choice<NegativeVolume>(module, "NegativeVolume",
                              {{"stop", NegativeVolume::stop}, {"erode", NegativeVolume::erode}});
  bind_choice<InsideOut>(module, "InsideOut",
                         {{"warn", InsideOut::warn}, {"erode", InsideOut::erode}, {"stop", InsideOut::stop}});
  bind_choice<StrainRate>(
      module, "StrainRate",
      {{"total", StrainRate::total}, {"deviatoric", StrainRate::deviatoric}, {"plastic", StrainRate::plastic}});
  bind_choice<RateInterpolation>(
      module, "RateInterpolation",
      {{"linear", RateInterpolation::linear}, {"logarithmic", RateInterpolation::logarithmic}});
  bind_choice<MassScaling>(module, "MassScaling", {{"small", MassScaling::small}, {"all", MassScaling::all}});
  bind_data<TimeSettings>(module, "TimeSettings", "[time] of a scene")
      .def_readwrite("end", &TimeSettings::end, "when the run stops [time]")
      .def_readwrite("cfl", &TimeSettings::cfl, "fraction of the stable step [-]")
      .def_readwrite("steps", &TimeSettings::steps, "stop after so many; -1: no limit")
      .def_readwrite("subcycling", &TimeSettings::subcycling, "larger elements make larger steps")
      .def_readwrite("smallest_step", &TimeSettings::smallest_step, "which mass is added for; 0: none [time]")
      .def_readwrite("mass_scaling", &TimeSettings::mass_scaling, "whose mass changes for it");
  bind_data<ElementSettings>(module, "ElementSettings", "[element] of a scene")
      .def_readwrite("hourglass", &ElementSettings::hourglass)
      .def_readwrite("hourglass_coefficient", &ElementSettings::hourglass_coefficient,
                     "[-]; negative: the default of the form")
      .def_readwrite("bulk_viscosity", &ElementSettings::bulk_viscosity)
      .def_readwrite("linear_viscosity", &ElementSettings::linear_viscosity, "[-]")
      .def_readwrite("quadratic_viscosity", &ElementSettings::quadratic_viscosity, "[-]")
      .def_readwrite("negative_volume", &ElementSettings::negative_volume)
      .def_readwrite("inside_out", &ElementSettings::inside_out)
      .def_readwrite("folding_resistance", &ElementSettings::folding_resistance,
                     "modulus of corners that are about to turn over, of the bulk modulus [-]");
  bind_data<ContactSettings>(module, "ContactSettings", "[contact] of a scene")
      .def_readwrite("method", &ContactSettings::method)
      .def_readwrite("enforcement", &ContactSettings::enforcement)
      .def_readwrite("gap", &ContactSettings::gap)
      .def_readwrite("beta", &ContactSettings::beta, "penalty factor [-]")
      .def_readwrite("damping", &ContactSettings::damping, "fraction of critical damping [-]")
      .def_readwrite("friction", &ContactSettings::friction, "Coulomb coefficient while sliding [-]")
      .def_readwrite("static_friction", &ContactSettings::static_friction,
                     "the same at rest [-]; negative: as friction")
      .def_readwrite("friction_decay", &ContactSettings::friction_decay,
                     "between both, over the velocity [time/length]")
      .def_readwrite("radius", &ContactSettings::radius)
      .def_readwrite("radius_factor", &ContactSettings::radius_factor, "on the radii of the balls [-]")
      .def_readwrite("self", &ContactSettings::self, "whether a body may touch itself")
      .def_readwrite("search", &ContactSettings::search)
      .def_readwrite("overlap", &ContactSettings::overlap, "of bodies at the start")
      .def_readwrite("skin", &ContactSettings::skin, "how far a node may stray before a search, over its radius [-]");
  bind_data<SkipSettings>(module, "SkipSettings", "[skip] of a scene")
      .def_readwrite("contact_search", &SkipSettings::contact_search)
      .def_readwrite("resting", &SkipSettings::resting);
  bind_data<GuardSettings>(module, "GuardSettings", "[guard] of a scene")
      .def_readwrite("energy_error", &GuardSettings::energy_error, "largest error of the energy balance [-]")
      .def_readwrite("time_step_collapse", &GuardSettings::time_step_collapse, "smallest step over the largest [-]");
  bind_data<OutputSettings>(module, "OutputSettings", "[output] of a scene, for run_recorded()")
      .def_readwrite("interval", &OutputSettings::interval,
                     "between rows of the history [time]; 0: 200 rows in the run")
      .def_readwrite("every_step", &OutputSettings::every_step)
      .def_readwrite("field_interval", &OutputSettings::field_interval, "between field files [time]; 0: none")
      .def_readwrite("field_times", &OutputSettings::field_times, "[time]")
      .def_readwrite("fields", &OutputSettings::fields)
      .def_readwrite("body_energies", &OutputSettings::body_energies,
                     "energies, momentum and mass of each body in the history");
}

}  // namespace pinball::python
