#pragma once

/// What the laws of a material keep of an element beside stress and plastic strain. All of it lies in one array
/// (ElementView::material_state), so that a law that keeps something more has to be known by nothing that stores,
/// copies or checks a state. All of it is zero at rest.
namespace pinball {

/// Where a material has its numbers among those of an element; negative: it has none such.
struct MaterialPlaces {
  int back_stress = -1;  ///< five: xx yy xy yz zx [stress]
  int temperature = -1;  ///< above that of the undeformed material [temperature]
  int energy = -1;       ///< e of equation_of_state.hpp [stress]
  int compaction = -1;   ///< m of equation_of_state.hpp [-]
  int torn = -1;         ///< 1: bears no tension any more, of equation_of_state.hpp [-]
  int damage = -1;       ///< 1: has failed [-]
  int hardening = -1;    ///< e_h of johnson_cook.hpp [-]
  int bulking = -1;      ///< b of johnson_holmquist.hpp [stress]
  int beside = -1;       ///< six: xx yy zz xy yz zx of crushable_foam.hpp [stress]
  int strain = -1;       ///< six: xx yy zz xy yz zx of e of failure.hpp [-]
  int deformation = -1;  ///< six: xx yy zz xy yz zx of E of mooney_rivlin.hpp and ogden.hpp [-]
  int gradient = -1;     ///< nine: H of orthotropic.hpp, row by row [-]
  int numbers = 0;       ///< all of them
};

}  // namespace pinball
