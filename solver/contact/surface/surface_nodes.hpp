#pragma once

namespace pinball {

/// Arrays of nodes in the memory of some execution space: records of four numbers (NodeRecords), and masses.
template <class S>
struct SurfaceNodes {
  const S* position = nullptr;      ///< [length]
  const S* velocity = nullptr;      ///< at the middle of the last step [length/time]
  S* force = nullptr;               ///< force, contact stiffness [force], [force/length]
  const S* inverse_mass = nullptr;  ///< one per node [1/mass]
};

}  // namespace pinball
