// Every kernel that a device will run, instantiated for one lane per thread. It is compiled, not run.
#if defined(__HIPCC__)
#include <hip/hip_runtime.h>
#endif

#include "kernel_headers.hpp"

namespace {

using namespace pinball;

// Parameters of class type confuse the compiler in a __global__ template, so that plain ones choose the features.
template <class S, bool everything, HourglassKind hourglass, YieldLaw yield = YieldLaw::linear>
__global__ void update_elements(ElementView<S> elements, NodeView<S> nodes, ElementConstants<S> constants, S dt,
                                ElementSums<S>* sums, S* corner_force) {
  constexpr ElementFeatures features{everything, everything, everything, hourglass, yield};
  const std::int64_t element = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  update_element_pack<S, features, 32>(elements, nodes, constants, ElementStep<S>{dt}, element, 0, sums[element],
                                       KeptAtCorners<S>{corner_force});
}

/// Nodes have more digits than elements.
__global__ void update_mixed_elements(ElementView<float> elements, NodeView<double> nodes,
                                      ElementConstants<float> constants, ElementSums<float>* sums, bool* in_rows) {
  constexpr ElementFeatures features{true, true, true, HourglassKind::assumed_strain, YieldLaw::linear};
  const std::int64_t element = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  in_rows[element] = lie_in_rows<float>(elements.corner + element);
  update_element_pack<float, features, 32>(elements, nodes, constants, ElementStep<float>{}, element, 0, sums[element],
                                           AddedToNodes<double>{nodes.force});
}

/// Tetrahedra: one kernel.
template <class S>
__global__ void update_tetrahedra(ElementView<S> elements, NodeView<S> nodes, ElementConstants<S> constants,
                                  ElementSums<S>* sums, S* corner_force) {
  constexpr ElementFeatures features{true, true, true, HourglassKind::none, YieldLaw::general, true, true};
  const std::int64_t element = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  update_tetrahedron_pack<S, features, 32>(elements, nodes, constants, ElementStep<S>{}, element, 0, sums[element],
                                           KeptAtCorners<S>{corner_force});
}

/// And what comes before it.
template <class S>
__global__ void average_volumes(NodalVolumeView<S> volumes, ElementView<S> elements, NodeView<S> nodes) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  FindsVolumes<S, S, 32>{volumes, elements.corner, elements.mass, nodes.position}(i);
  AveragesVolumes<S>{volumes}(i);
  TakesAveragedVolumes<S, S, 32>{volumes, elements.volume_ratio}(i);
}

template <class S>
__global__ void sum_corner_forces(CornersOfNodes corners, const S* corner_force, S* force) {
  const std::int64_t node = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  add_corner_forces<32>(corners, corner_force, node, force + 4 * node);
}

template <class S>
__global__ void update_pinballs(UpdatePinballs<S, true> update, NodesStray<S> strays, BallsGrow<S> grows, bool* any) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  update(i);
  any[i] = strays(i) || grows(i);
}

template <class S>
__global__ void contact_forces(FindPairForces<S> find, PinballGeometryView<S> pinballs, SumPairForces<S> sum,
                               LoadNodes<S> load, PairSums<S>* sums, LargestOf<S>* row) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  find.pinballs = pinballs_of(pinballs);
  PairSums<S> own;
  find(i, own);
  sums[i].join(own);
  sum(i);
  load(i, row[i]);
}

template <class S>
__global__ void add_contact_forces(const PairTouch<S, 1>* touch, std::int32_t pinballs, S* force) {
  const std::int64_t pair = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  add_to_pinballs<S>(touch[pair], 1, pinballs, force);
}

__global__ void contact_rows(const Vec3<double>* d, const double* reach, const Vec3<double>* normal, ContactRow* row) {
  const std::int64_t pair = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  row[pair] = pinball_row(d[pair], reach[pair], normal[2 * pair], normal[2 * pair + 1]);
}

/// b, then what is allowed of it, and what of it is free.
__global__ void row_impulses(const Vec3<double>* direction, const double* coefficient, Vec3<double>* impulse,
                             Vec3<double>* free) {
  const std::int64_t row = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const Vec3<double> b = impulse[row];
  const FrictionBound bound{coefficient[row], 0};
  impulse[row] = allowed_impulse(b, direction[row], bound);
  free[row] = free_part(freedom_of(impulse[row], direction[row], bound, free[row]), direction[row], b);
}

__global__ void move_nodes(const ImpulseNode* nodes, const std::int32_t* rows, const std::int32_t* row,
                           const double* weight, const double* impulses, Vec3<double>* change) {
  const std::int64_t node = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const std::int32_t first = rows[node];
  change[node] = moved_by(nodes[node], weighted_sum(rows[node + 1] - first, row + first, weight + first, impulses));
}

__global__ void friction_mobilities(const ImpulseNode* nodes, double* mobility) {
  const std::int64_t node = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  mobility[node] = friction_mobility(nodes[node]);
}

/// point: the corners of a face and a node.
template <class S>
__global__ void feet_on_faces(const Vec3<S>* point, FaceProjection<S>* foot, FaceProjection<S>* projection) {
  const std::int64_t pair = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const Vec3<S>* const at = point + 5 * pair;
  const Vec3<S> corner[4] = {at[0], at[1], at[2], at[3]};
  foot[pair] = foot_on_face(corner, at[4]);
  move_to_nearest_side(corner, at[4], foot[pair]);
  foot[pair].gap = move_to_line(corner, foot[pair].gap * foot[pair].normal, foot[pair].normal, foot[pair].weight);
  projection[pair] = project_onto_face(corner, at[4], S(0), S(0));
}

template <class S>
__global__ void pairs_of_edges(const Vec3<S>* end, EdgePair<S>* pairs) {
  const std::int64_t pair = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const Vec3<S>* const at = end + 4 * pair;
  pairs[pair] = nearest_points(at[0], at[1], at[2], at[3]);
}

/// point: the corners of an element.
template <class S>
__global__ void least_corners(const Vec3<S>* point, const S* volume, S* share) {
  const std::int64_t element = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  Vec3<S> corner[8];
  for (int i = 0; i < 8; ++i) corner[i] = point[8 * element + i];
  share[element] = least_corner_share(corner, volume[element]);
}

/// value: of the corners of collapsed hexahedra.
template <class S>
__global__ void sum_corners_of_wedges(const S* value, S* sum, std::int64_t count) {
  const std::int64_t element = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  if (element >= count) return;
  for (int node = 0; node < 6; ++node) sum[element] += value[8 * element + wedge_corner(node)];
}

template <class S>
__global__ void box_balls(const S* ball, S* level, S* next) {
  const std::int64_t group = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  put_box(box_of_balls<S>(ball + group * 7 * ball_group<S>), level, group);
  put_box(box_of_boxes<S>(level + group * 12 * ball_group<S>), next, group);
}

template <class S>
__global__ void find_meeting_boxes(BallTreeView<S> tree, std::int32_t* count) {
  const std::int64_t group = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const MovingBox<S> box = get_box(tree.boxes(0, 0), group);
  for_each_meeting_box<S>(tree, box, 0, 0, [&](std::int32_t) { ++count[group]; });
  count[group] += __popc(meeting_boxes<S, false>(tree.boxes(0, 0), empty_box<S>())) + (tree.balls(group)[0] > S(0) ? 1 : 0);
}

template <class S>
__global__ void find_meeting_balls(const S* own, const S* others, const float* reference, unsigned* bits) {
  const std::int64_t group = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  BallBits<ball_group<S>> meeting = maybe_meeting_balls<S, true>(own, others);
  for (int i = 0; i < ball_group<S>; ++i) {
    meeting.clear_in_row(i, balls_of_one_body<S>(reference, reference).row(i));
    meeting.clear_in_row(i, balls_apart<S>(reference, reference).row(i));
    const unsigned all = meeting.row(i) & test_ball<S, ball_group<S>>(i, maybe_meeting_test<S, false>(own, others));
    if (meeting.any()) bits[ball_group<S> * group + i] = all & meeting_balls<S>(own, i, others);
  }
}

__global__ void write_what_bits_tell(const unsigned* bits, const double* from, double* to, std::int32_t* number) {
  const std::int64_t pack = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  write_lanes<8>(bits[pack], from + 8 * pack, to + 8 * pack);
  write_numbers<8>(bits[pack], 0, number + 8 * pack);
}

template <class S>
__global__ void integrate_nodes(S* position, S* velocity, S* force, const S* inverse_mass, const S* normal, S dt,
                                MotionEnergy* energy) {
  const std::int64_t node = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  constrain_node(force + 4 * node, velocity + 4 * node, normal);
  energy[node].add(1.0, integrate_node(position + 4 * node, velocity + 4 * node, force + 4 * node, inverse_mass[node], dt,
                                       dt, dt));
}

template <class S>
__global__ void prepare_moduli(const S* lame, AssumedStrainModuli<S>* moduli, S* hourglass) {
  const std::int64_t material = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const auto kind = static_cast<HourglassKind>(material % 4);
  const bool kept = keeps_hourglass_state(kind) && stores_hourglass_modes(kind);
  moduli[material] = assumed_strain_moduli(lame[2 * material], lame[2 * material + 1], S(1));
  hourglass[material] = kept ? hourglass_modulus(lame[2 * material], lame[2 * material + 1]) : lane_numbers<S>();
}

__global__ void find_coordinates(CellGrid grid, const double* position, std::int32_t* coordinate) {
  const std::int64_t number = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  for (int axis = 0; axis < 3; ++axis)
    coordinate[3 * number + axis] = grid.coordinate(position[3 * number + axis], axis);
}

__global__ void copy_cells(SpatialHashView hash, const HashBox* boxes, HashBox* copies, std::int32_t* count) {
  const std::int64_t box = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  const HashCell cell = cell_of(boxes[box]);
  HashBox* const begin = copies + 64 * box;
  count[box] = static_cast<std::int32_t>(
      copy_cell(hash, bucket_of(cell, hash.bits), cell, limits_of(boxes[box]), begin) - begin);
}

template <class Functor>
__global__ void call_on_all(Functor functor) {
  functor(blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x);
}

template <class Functor, class Value>
__global__ void add_up(Functor functor, Value* partial) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  Value sum{};
  functor(i, sum);
  sum.join(sum);
  partial[i] = sum;
}

template <class Functor>
__global__ void add_up_numbers(Functor functor, double* partial) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  functor(i, partial[i]);
}

template <class S, class Functor>
__global__ void pass_by(Functor functor, bool* passes) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  passes[i] = functor.template passes<S>(i);
}

template <class S>
__global__ void turn(const Tensor<S>* gradient, Rotation<S>* rotation) {
  const std::int64_t i = blockIdx.x * std::int64_t(blockDim.x) + threadIdx.x;
  rotation[i] = hughes_winget_rotation(axial_vector(gradient[i]));
}

template <class S, class Forces>
void instantiate_forces(const Forces& forces) {
  const NodeArrays<S> nodes{};
  call_on_all<<<1, 32>>>(AddForces<S, Forces>{nodes, forces});
  add_up<<<1, 32>>>(WorkOfForces<S, Forces>{nodes, forces, {}}, static_cast<ExternalWork*>(nullptr));
  add_up<<<1, 32>>>(TotalOfForces<S, Forces>{nodes, forces}, static_cast<VectorSum*>(nullptr));
}

template <class S>
void instantiate_boundary() {
  instantiate_forces<S>(SharedForce<S>{});
  instantiate_forces<S>(GravityForce<S>{});
  instantiate_forces<S>(PartGravityForce<S>{});
  instantiate_forces<S>(DampingForce<S>{});
  instantiate_forces<S>(GivenForce<S>{});
  instantiate_forces<S>(PressureForce<S>{});
  instantiate_forces<S>(MovingForce<S>{});
  call_on_all<<<1, 32>>>(PressFaces<S>{});
  call_on_all<<<1, 32>>>(GatherPressure<S>{});
  call_on_all<<<1, 32>>>(ConstrainNodes<S>{});
  call_on_all<<<1, 32>>>(MoveNodes<S>{});
  call_on_all<<<1, 32>>>(ReflectNodes<S>{});
  call_on_all<<<1, 32>>>(KeepForcesAcross<S>{});
  add_up<<<1, 32>>>(SumReflection<S>{}, static_cast<Reflection*>(nullptr));
  call_on_all<<<1, 32>>>(PushHeldNodes<S>{});
  add_up_numbers<<<1, 32>>>(EnergyAlong<S>{}, nullptr);
  add_up<<<1, 32>>>(StopAtWall<S>{}, static_cast<WallStop*>(nullptr));
  add_up<<<1, 32>>>(ForceOfTable<double, NodeConstraint<S>>{}, static_cast<VectorSum*>(nullptr));
  add_up<<<1, 32>>>(ForceOfTable<S, NodePrescription<S>>{}, static_cast<VectorSum*>(nullptr));
  add_up<<<1, 32>>>(PushWall<S>{}, static_cast<WallPush*>(nullptr));
  add_up<<<1, 32>>>(WorkOfWall<S>{}, static_cast<ExternalWork*>(nullptr));
  pass_by<S><<<1, 32>>>(StopAtWall<S>{}, nullptr);
}

template <class S>
void instantiate() {
  update_elements<S, true, HourglassKind::stiffness><<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_elements<S, true, HourglassKind::assumed_strain><<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_elements<S, true, HourglassKind::assumed_strain, YieldLaw::general>
      <<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_elements<S, true, HourglassKind::viscous><<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_elements<S, true, HourglassKind::viscous, YieldLaw::general><<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_elements<S, false, HourglassKind::viscous><<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_elements<S, false, HourglassKind::none><<<1, 32>>>({}, {}, {}, S(0), nullptr, nullptr);
  update_tetrahedra<S><<<1, 32>>>({}, {}, {}, nullptr, nullptr);
  average_volumes<S><<<1, 32>>>({}, {}, {});
  turn<S><<<1, 32>>>(nullptr, nullptr);
  prepare_moduli<S><<<1, 32>>>(nullptr, nullptr, nullptr);
  update_pinballs<S><<<1, 32>>>({}, {}, {}, nullptr);
  contact_forces<S><<<1, 32>>>({}, {}, {}, {}, nullptr, nullptr);
  sum_corner_forces<S><<<1, 32>>>({}, nullptr, nullptr);
  add_contact_forces<S><<<1, 32>>>(nullptr, 0, nullptr);
  feet_on_faces<S><<<1, 32>>>(nullptr, nullptr, nullptr);
  pairs_of_edges<S><<<1, 32>>>(nullptr, nullptr);
  least_corners<S><<<1, 32>>>(nullptr, nullptr, nullptr);
  sum_corners_of_wedges<S><<<1, 32>>>({}, {}, {});
  box_balls<S><<<1, 32>>>(nullptr, nullptr, nullptr);
  find_meeting_boxes<S><<<1, 32>>>({}, nullptr);
  find_meeting_balls<S><<<1, 32>>>(nullptr, nullptr, nullptr, nullptr);
  integrate_nodes<S><<<1, 32>>>(nullptr, nullptr, nullptr, nullptr, nullptr, S(0), nullptr);
}

}  // namespace

void instantiate_kernels() {
  copy_cells<<<1, 32>>>({}, nullptr, nullptr, nullptr);
  find_coordinates<<<1, 32>>>({}, nullptr, nullptr);
  contact_rows<<<1, 32>>>(nullptr, nullptr, nullptr, nullptr);
  row_impulses<<<1, 32>>>(nullptr, nullptr, nullptr, nullptr);
  move_nodes<<<1, 32>>>(nullptr, nullptr, nullptr, nullptr, nullptr, nullptr);
  friction_mobilities<<<1, 32>>>(nullptr, nullptr);
  write_what_bits_tell<<<1, 32>>>(nullptr, nullptr, nullptr, nullptr);
  update_mixed_elements<<<1, 32>>>({}, {}, {}, nullptr, nullptr);
  instantiate<double>();
  instantiate<float>();
  instantiate_boundary<double>();
  instantiate_boundary<float>();
}
