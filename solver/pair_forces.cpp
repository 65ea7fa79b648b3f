#include <algorithm>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/pair_forces.hpp>

namespace pinball {

namespace {

template <class S>
void add(S* force, std::int32_t pinball, const S (&touch)[4], S sign) {
  S* f = force + 4 * static_cast<std::int64_t>(pinball);
  for (int k = 0; k < 3; ++k) f[k] += sign * touch[k];
  f[3] += touch[3];
}

}  // namespace

template <class S>
void PairForces<S>::find_touching(const PinballView<S>& view, PairList<S>& list, std::int64_t piece, Work& work) {
  using T = Pack<S, native_width<S>>;
  constexpr std::int64_t W = native_width<S>;
  const auto [begin, end, pinballs_begin, pinballs_end] = list.piece(piece);
  work.touching.clear();
  for (std::int64_t place = begin; place < end; place += W) {
    unsigned bits = touching_pairs<T>(view.centre, list.first() + place, list.second() + place, list.offset() + place);
    for (; bits != 0; bits &= bits - 1) {
      const std::int64_t touching = place + __builtin_ctz(bits);
      if (touching < end) work.touching.push_back(touching);
    }
  }
}

template <class S>
void PairForces<S>::work_out(const PinballView<S>& view, const PenaltyConstants<S>& constants, PairList<S>& list, S dt,
                             Work& work) {
  using T = Pack<S, native_width<S>>;
  constexpr std::size_t W = native_width<S>;
  work.touches.clear();
  work.sums = {};
  const std::size_t count = work.touching.size();
  for (std::size_t begin = 0; begin < count; begin += W) {
    const std::size_t pairs = std::min(W, count - begin);
    alignas(64) std::int32_t first[W], second[W];
    alignas(64) S offset[W], stored[W], damped[W], ratio[W], force[4][W];
    for (std::size_t i = 0; i < W; ++i) {  // what is missing to a pack repeats a pair
      const auto place = static_cast<std::size_t>(work.touching[begin + std::min(i, pairs - 1)]);
      first[i] = list.first()[place];
      second[i] = list.second()[place];
      offset[i] = list.offset()[place];
    }
    T offsets = load<T>(offset);
    const PairForce<T> f = pair_force(view, constants, first, second, offsets, dt);
    store(offsets, offset);
    store(f.stored, stored);
    store(f.damped, damped);
    store(f.penetration_ratio, ratio);
    store(f.force.x, force[0]);
    store(f.force.y, force[1]);
    store(f.force.z, force[2]);
    store(f.stiffness, force[3]);
    for (std::size_t i = 0; i < pairs; ++i) {
      const auto place = static_cast<std::size_t>(work.touching[begin + i]);
      list.offset()[place] = offset[i];
      list.stored()[place] = stored[i];
      if (offset[i] < S(0)) continue;
      work.touches.push_back({first[i], second[i], {force[0][i], force[1][i], force[2][i], force[3][i]}});
      work.sums.stored += static_cast<double>(stored[i]);
      work.sums.damped += static_cast<double>(damped[i]);
      work.sums.penetration_ratio = maximum(work.sums.penetration_ratio, ratio[i]);
      ++work.sums.pairs;
    }
  }
}

template <class S>
PairSums<S> PairForces<S>::compute(const PinballView<S>& view, const PenaltyConstants<S>& constants, PairList<S>& list,
                                   S dt, S* force) {
  const auto work_of = [this](std::int64_t piece) -> Work& { return work_[static_cast<std::size_t>(piece)]; };
  parallel_for("contact forces", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    find_touching(view, list, piece, work_of(piece));
    work_out(view, constants, list, dt, work_of(piece));
    const auto& range = list.piece(piece);
    std::fill(force + 4 * static_cast<std::int64_t>(range.pinballs_begin),
              force + 4 * static_cast<std::int64_t>(range.pinballs_end), S(0));
  });
  // Second pinballs of other pieces: these pairs come before all that begin with the pinball's own piece.
  for (std::int64_t piece = 0; piece < pieces; ++piece) {
    for (const Touch& t : work_of(piece).touches) {
      if (t.second >= list.piece(piece).pinballs_end) add(force, t.second, t.force, S(-1));
    }
  }
  parallel_for("contact force sums", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    for (const Touch& t : work_of(piece).touches) {
      add(force, t.first, t.force, S(1));
      if (t.second < list.piece(piece).pinballs_end) add(force, t.second, t.force, S(-1));
    }
  });
  PairSums<S> sums;
  for (const Work& work : work_) {
    sums.stored += work.sums.stored;
    sums.damped += work.sums.damped;
    sums.penetration_ratio = maximum(sums.penetration_ratio, work.sums.penetration_ratio);
    sums.pairs += work.sums.pairs;
  }
  return sums;
}

template <class S>
std::size_t PairForces<S>::bytes() const {
  std::size_t sum = 0;
  for (const Work& work : work_) {
    sum += work.touching.capacity() * sizeof(work.touching[0]) + work.touches.capacity() * sizeof(Touch);
  }
  return sum;
}

template class PairForces<double>;
template class PairForces<float>;

}  // namespace pinball
