#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <solver/model/model.hpp>

#include "extent.hpp"

namespace pinball {

/// A part of a mover at the start.
struct MoverCell {
  Extent box;
  std::int32_t body = 0;
};

/// How far a mover is gone, as vectors and a length, which turn with the scene as no box does: no place of it is
/// further from all of these ways than the spread, but for what turns it.
struct Drift {
  std::vector<Point> ways;  ///< [length]
  double spread = 0;        ///< [length]
};

/// Bodies that go together, because they have nodes in common or are tied all the time, and where they may be in the
/// course of a run.
struct Mover {
  std::vector<std::int32_t> bodies;
  std::vector<MoverCell> cells;  ///< together they hold all its elements, at the start
  Extent box;                    ///< all of the cells
  std::vector<Extent> moved;     ///< displacements that its places may have, at each of the times [length]
  std::vector<Extent> strayed;   ///< the same, with what a deformation or a rebound may add [length]
  std::vector<Drift> drift;      ///< at each of the times
  double speed = 0;              ///< largest, but for what a load or gravity gives it [length/time]
  std::optional<Extent> sphere;  ///< in which it is if loads or pressures turn it: whether they do depends on much
  bool turns = false;            ///< as given, or by loads or pressures
  bool round = false;            ///< the box is that of a ball, for as far as is known it turns all ways
  bool held = false;             ///< no node of it can move
  bool meets_wall = false;       ///< a rigid wall, or one moves towards it
};

struct Movers {
  std::vector<double> times;  ///< ascending, from 0 to the end of the run
  std::vector<Mover> all;
  bool anything_moves = false;  ///< by a velocity, a prescribed one, a load, gravity or a wall
};

/// Follows initial velocities, spins, prescribed motion, gravity, loads and pressures, as if nothing met anything.
/// mesh: with the ties of the scene found.
Movers find_movers(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
