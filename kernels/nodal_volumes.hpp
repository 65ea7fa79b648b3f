#pragma once

#include "element_data.hpp"
#include "tetrahedron.hpp"

/// Volumes of tetrahedra averaged over nodes (element/tetrahedron_step.hpp), in three loops: over the tetrahedra, over
/// the nodes, and over the tetrahedra once more. Around a node those of each part are averaged apart: materials do not
/// share theirs. Functors of pointers alone, for the memory of any execution space; L: elements in a row of the arrays.
namespace pinball {

template <class S>
struct NodalVolumeView {
  const std::int64_t* place;   ///< per tetrahedron: where it is among all elements
  const std::int32_t* group;   ///< [4 t + i]: of its node i, with its part
  const S* undeformed;         ///< per tetrahedron [length^3]
  S* volume;                   ///< the same; eroded: 0
  const std::int32_t* first;   ///< [groups + 1]: where the tetrahedra of each begin in `around`
  const std::int32_t* around;  ///< tetrahedra, ascending by their places
  S* ratio;                    ///< per group: J_a [-]
};

/// Of tetrahedron t.
template <class E, class S, int L>
struct FindsVolumes {
  NodalVolumeView<S> of;
  const std::int32_t* corner;  ///< of ElementView
  const E* mass;               ///< of ElementView
  const S* position;           ///< of NodeView

  PINBALL_FUNCTION void operator()(std::int64_t t) const {
    const std::int64_t place = of.place[t];
    const std::int32_t* const own = corner + place_in_rows<L>(place, 8);
    const Vec3<S> a = node(own, 0);
    const TetrahedronEdges<S> x{{node(own, 1) - a, node(own, 2) - a, node(own, 3) - a}};
    of.volume[t] = mass[place] > E(0) ? tetrahedron_volume(uniform_gradient(x), x) : S(0);
  }

 private:
  PINBALL_FUNCTION Vec3<S> node(const std::int32_t* own, int i) const {
    const S* const x = position + 4 * static_cast<std::int64_t>(own[tetrahedron_corner(i) * L]);
    return {x[0], x[1], x[2]};
  }
};

/// J_a = sum v / sum V, over what is not eroded.
template <class E, class S>
struct AveragesVolumes {
  NodalVolumeView<S> of;
  const E* mass;  ///< of ElementView

  PINBALL_FUNCTION void operator()(std::int64_t group) const {
    S now = 0, undeformed = 0;
    for (std::int32_t i = of.first[group]; i < of.first[group + 1]; ++i) {
      const std::int32_t t = of.around[i];
      now += of.volume[t];
      if (mass[of.place[t]] > E(0)) undeformed += of.undeformed[t];
    }
    of.ratio[group] = undeformed > S(0) ? now / undeformed : S(1);
  }
};

/// J = 1/4 (J_A + J_B + J_C + J_D); that of the step before is kept.
template <class E, class S, int L>
struct TakesAveragedVolumes {
  NodalVolumeView<S> of;
  E* ratio;  ///< volume_ratio of ElementView

  PINBALL_FUNCTION void operator()(std::int64_t t) const {
    E* const own = ratio + place_in_rows<L>(of.place[t], 2);
    const std::int32_t* const g = of.group + 4 * t;
    own[L] = own[0];
    own[0] = static_cast<E>(S(0.25) * ((of.ratio[g[0]] + of.ratio[g[1]]) + (of.ratio[g[2]] + of.ratio[g[3]])));
  }
};

}  // namespace pinball
