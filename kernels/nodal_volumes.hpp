#pragma once

#include "element_data.hpp"
#include "hexahedron.hpp"
#include "tetrahedron.hpp"
#include "wedge.hpp"

/// Volumes of tetrahedra and wedges averaged over nodes (element/averaged_step.hpp), in three loops: over
/// the elements, over the nodes, and over the elements once more. Around a node those of each material are averaged
/// apart. Functors of pointers alone, for the memory of any execution space; L: elements in a row of the arrays.
namespace pinball {

/// What stands for the volume of an eroded element, and says so to who does not have its mass: no volume is as small.
template <class S>
inline constexpr S eroded_volume = S(-3e38);  // which single precision just holds

template <class S>
struct NodalVolumeView {
  const std::int64_t* place;  ///< per element that takes part: where it is among all elements
  const std::int32_t*
      corners;  ///< [elements + 1]: where those of each begin in `group`: 4 of a tetrahedron, 6 of a wedge
  const std::int32_t* group;   ///< of each of these corners: its node, with the material
  const S* undeformed;         ///< per element [length^3]
  S* volume;                   ///< per element: of four of its nodes; eroded: eroded_volume [length^3]
  const std::int32_t* first;   ///< [groups + 1]: where the elements of each begin in `around`
  const std::int32_t* around;  ///< elements, ascending by their places, as often as they have corners there
  S* ratio;                    ///< per group: J_a [-]

  PINBALL_FUNCTION bool is_tetrahedron(std::int64_t t) const { return corners[t + 1] - corners[t] == 4; }
};

/// Of element t.
template <class E, class S, int L>
struct FindsVolumes {
  NodalVolumeView<S> of;
  const std::int32_t* corner;  ///< of ElementView
  const E* mass;               ///< of ElementView
  const S* position;           ///< of NodeView

  PINBALL_FUNCTION void operator()(std::int64_t t) const {
    const std::int64_t place = of.place[t];
    const std::int32_t* const own = corner + place_in_rows<L>(place, 8);
    if (!(mass[place] > E(0))) {
      of.volume[t] = eroded_volume<S>;
    } else if (of.is_tetrahedron(t)) {
      const Vec3<S> a = node(own, tetrahedron_corner(0));
      const TetrahedronEdges<S> x{{node(own, tetrahedron_corner(1)) - a, node(own, tetrahedron_corner(2)) - a,
                                   node(own, tetrahedron_corner(3)) - a}};
      of.volume[t] = tetrahedron_volume(uniform_gradient(x), x);
    } else {
      Vec3<S> x[8];
      x[0] = {S(0), S(0), S(0)};
      const Vec3<S> a = node(own, 0);
      for (int i = 1; i < 8; ++i) x[i] = node(own, i) - a;
      const HexahedronModes<S> modes = to_modes(x);
      of.volume[t] = S(2.0 / 3.0) * hexahedron_volume(uniform_gradient(modes), modes);
    }
  }

 private:
  PINBALL_FUNCTION Vec3<S> node(const std::int32_t* own, int i) const {
    const S* const x = position + 4 * static_cast<std::int64_t>(own[i * L]);
    return {x[0], x[1], x[2]};
  }
};

/// J_a = sum v / sum V, over what is not eroded.
template <class S>
struct AveragesVolumes {
  NodalVolumeView<S> of;

  PINBALL_FUNCTION void operator()(std::int64_t group) const {
    S now = 0, undeformed = 0;
    for (std::int32_t i = of.first[group]; i < of.first[group + 1]; ++i) {
      const std::int32_t t = of.around[i];
      if (of.volume[t] == eroded_volume<S>) continue;
      now += of.volume[t];
      undeformed += of.undeformed[t];
    }
    of.ratio[group] = undeformed > S(0) ? now / undeformed : S(1);
  }
};

/// J, the mean of J_a over the nodes; that of the step before is kept.
template <class E, class S, int L>
struct TakesAveragedVolumes {
  NodalVolumeView<S> of;
  E* ratio;  ///< volume_ratio of ElementView

  PINBALL_FUNCTION void operator()(std::int64_t t) const {
    E* const own = ratio + place_in_rows<L>(of.place[t], 2);
    const std::int32_t* const g = of.group + of.corners[t];
    own[L] = own[0];
    own[0] = static_cast<E>(of.is_tetrahedron(t) ? of_four(g) : of_six(g));
  }

 private:
  PINBALL_FUNCTION S of_four(const std::int32_t* g) const {
    return S(0.25) * ((of.ratio[g[0]] + of.ratio[g[1]]) + (of.ratio[g[2]] + of.ratio[g[3]]));
  }
  PINBALL_FUNCTION S of_six(const std::int32_t* g) const {
    return S(1.0 / 6.0) * (((of.ratio[g[0]] + of.ratio[g[1]]) + of.ratio[g[2]]) +
                           ((of.ratio[g[3]] + of.ratio[g[4]]) + of.ratio[g[5]]));
  }
};

}  // namespace pinball
