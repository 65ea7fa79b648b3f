// Every kernel that a device will run, instantiated for one lane per thread. It is compiled, not run.
#include "kernel_headers.hpp"

namespace {

using namespace pinball;

// Parameters of class type confuse the compiler in a __global__ template, so that plain ones choose the features.
template <class S, bool everything>
__global__ void update_elements(ElementView<S> elements, NodeView<S> nodes, ElementConstants<S> constants, S dt,
                                ElementSums<S>* sums) {
  constexpr ElementFeatures features{everything, everything, everything,
                                     everything ? HourglassKind::stiffness : HourglassKind::viscous};
  const std::int64_t element = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  update_element_pack<S, features>(elements, nodes, constants, ElementStep<S>{dt}, element, 0, sums[element]);
}

template <class S>
__global__ void update_pinballs(PinballGeometryView<S> view, const S* position, const S* velocity) {
  const std::int64_t pinball = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  update_pinball_pack<S, true>(view, position, velocity, pinball);
}

template <class S>
__global__ void contact_forces(PinballView<S> view, PenaltyConstants<S> constants, const std::int32_t* first,
                               const std::int32_t* second, S* offset, S dt, PairForce<S>* force) {
  const std::int64_t pair = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  if (touching_pairs<S>(view.centre, first + pair, second + pair, offset + pair) == 0) return;
  force[pair] = pair_force<S>(view, constants, first + pair, second + pair, offset[pair], dt);
}

template <class S>
__global__ void integrate_nodes(S* position, S* velocity, S* force, const S* inverse_mass, const S* normal, S dt) {
  const std::int64_t node = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  constrain_node(force + 4 * node, velocity + 4 * node, normal);
  integrate_node(position + 4 * node, velocity + 4 * node, force + 4 * node, inverse_mass[node], dt, dt, dt);
}

__global__ void copy_cells(SpatialHashView hash, const HashBox* boxes, HashBox* copies, std::int32_t* count) {
  const std::int64_t box = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const HashCell cell = cell_of(boxes[box]);
  HashBox* const begin = copies + 64 * box;
  count[box] = static_cast<std::int32_t>(
      copy_cell(hash, bucket_of(cell, hash.bits), cell, limits_of(boxes[box]), begin) - begin);
}

template <class S>
void instantiate() {
  update_elements<S, true><<<1, 32>>>({}, {}, {}, S(0), nullptr);
  update_elements<S, false><<<1, 32>>>({}, {}, {}, S(0), nullptr);
  update_pinballs<S><<<1, 32>>>({}, nullptr, nullptr);
  contact_forces<S><<<1, 32>>>({}, {}, nullptr, nullptr, nullptr, S(0), nullptr);
  integrate_nodes<S><<<1, 32>>>(nullptr, nullptr, nullptr, nullptr, nullptr, S(0));
}

}  // namespace

void instantiate_kernels() {
  copy_cells<<<1, 32>>>({}, nullptr, nullptr, nullptr);
  instantiate<double>();
  instantiate<float>();
}
