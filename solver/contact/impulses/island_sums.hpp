#pragma once

#include <algorithm>
#include <limits>

/// What the loops of an island add up (IslandLoops::reduce).
namespace pinball::island {

struct Largest {
  double value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};
struct Sum {
  double value = 0;
  void join(const Sum& other) { value += other.value; }
};
/// Along a direction of the search: r . P q and q . P q, and how far it goes until an impulse is none.
struct Along {
  double descent = 0, size = 0;
  double room = std::numeric_limits<double>::infinity();
  void join(const Along& other) {
    descent += other.descent;
    size += other.size;
    room = std::min(room, other.room);
  }
};
/// After a step of the search: squares of projected steps of what is free and of what is bound, the largest of the
/// first, and whether friction has met its bound.
struct Progress {
  double free = 0, bound = 0, largest = 0;
  bool strays = false;
  void join(const Progress& other) {
    free += other.free;
    bound += other.bound;
    largest = std::max(largest, other.largest);
    strays = strays || other.strays;
  }
};

}  // namespace pinball::island
