#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <kernels/boundary/node_arrays.hpp>
#include <kernels/node_update.hpp>

#include "body_sums.hpp"
#include "common_numbers.hpp"
#include "device_halo.hpp"
#include "device_mesh.hpp"
#include "device_resting.hpp"
#include "element_totals.hpp"
#include "some_pieces.hpp"

namespace pinball {

enum class StateNumbers { position, velocity, stress, plastic_strain };

/// The loops of a step whose arrays lie in the memory of an execution space. Between two calls nothing but what they
/// return crosses over; the state does when it is asked for.
template <class S>
class DeviceStep {
 public:
  virtual ~DeviceStep() = default;

  virtual void write(const DeviceState<S>& state) = 0;  ///< from the host
  virtual void read(DeviceState<S>& state) const = 0;   ///< to the host, whose arrays get their sizes

  /// Stresses and corner forces of the elements after a step. Tiles at rest are left out.
  virtual ElementTotals<S> update_elements(const ElementStep<S>& step) = 0;
  /// The same; rates, per place: 2/dt of the stable step dt of each element [1/time].
  virtual ElementTotals<S> update_elements(const ElementStep<S>& step, Array<S>& rates) = 0;

  /// These tiles rest from now on. Before, none does.
  virtual void set_resting(const DeviceResting<S>& tiles) = 0;
  /// Before elements are updated: wakes the tiles that something has reached.
  virtual RestingTotals<S> wake() = 0;
  /// Per tile: whether it rests; after set_resting.
  virtual std::vector<std::uint8_t> read_resting() const = 0;

  /// What boundary conditions work on; good until the next write().
  virtual NodeArrays<S> nodes() = 0;
  /// Sums of the corner forces into those of the nodes, for those who add to them before nodes are integrated.
  virtual void sum_corner_forces() = 0;
  /// Velocities and positions of all nodes, and zero forces (node_update.hpp); sums the corner forces first where
  /// sum_corner_forces has not been called.
  virtual MotionEnergy integrate(const StepLengths& step) = 0;

  // ---- Of several ranks with a device each (DeviceMesh::is_shared) ----

  /// What this one works of the sums over each part, which update_elements() then keeps, and over all nodes.
  virtual void set_pieces(std::vector<SomePieces<S>> of_parts) = 0;
  virtual std::vector<SomePieces<S>>& pieces_of_parts() = 0;
  /// What crosses to others from the next update on.
  virtual void set_halo(const DeviceHalo& halo) = 0;
  /// Before update_elements(), of elements with averaged volumes: those that others need of this one
  /// (DeviceVolumes::sent), found of the positions that nodes have; what others have sent is to be at
  /// received_volumes() before scatter_volumes().
  virtual const S* gather_volumes(Messages on) = 0;
  virtual S* received_volumes(Messages on) = 0;
  virtual void scatter_volumes(Messages on) = 0;
  /// After update_elements(), and before their sums: three numbers for each corner that is sent; what others
  /// have sent is to be at received_halo() before scatter_halo().
  virtual const S* gather_halo(Messages on) = 0;
  virtual S* received_halo(Messages on) = 0;
  virtual void scatter_halo(Messages on) = 0;
  /// Nodes of some pieces of the sum over all; of_piece: of each piece.
  virtual void integrate(const StepLengths& step, PieceRange pieces, MotionEnergy* of_piece) = 0;
  /// Records of all nodes.
  virtual void read_nodes(S* position, S* velocity, S* force) const = 0;
  virtual void write_nodes(const S* position, const S* velocity, const S* force) = 0;

  // ---- Numbers that the host asks for or has changed ----

  /// The nodes whose numbers cross over in a step, each once.
  virtual void set_common(CommonSet of, const std::vector<std::int32_t>& nodes) = 0;
  /// Records of four (NodeView) in the order of these nodes, in one copy: positions and then velocities, and then
  /// forces, of which there are as `which` says.
  virtual void read_common(CommonSet of, NodeNumbers which, Array<S>& numbers) = 0;
  virtual void write_common(CommonSet of, NodeNumbers which, const Array<S>& numbers) = 0;
  /// Of all nodes [1/mass], [mass].
  virtual void write_masses(const S* inverse_mass, const double* mass) = 0;
  /// Places of elements that have eroded since the last call or write(), ascending.
  virtual std::vector<std::int64_t> take_eroded() = 0;
  /// Numbers of the state that stand at some places of their array (DeviceState).
  virtual std::vector<S> read_numbers(StateNumbers of, const std::vector<std::int64_t>& places) const = 0;
  /// Before body_sums().
  virtual void set_bodies(BodyElements elements) = 0;
  /// Per body.
  virtual std::vector<BodySum> body_sums() = 0;
  /// Per part, of the last update.
  virtual const std::vector<ElementTotals<S>>& totals_of_parts() const = 0;

  virtual std::size_t bytes() const = 0;  ///< on the device
};

/// Throws InputError where there is no such device.
template <class S>
std::unique_ptr<DeviceStep<S>> make_mock_step(const DeviceMesh<S>& mesh);
#if defined(PINBALL_WITH_CUDA) || defined(PINBALL_WITH_HIP)
template <class S>
std::unique_ptr<DeviceStep<S>> make_gpu_step(const DeviceMesh<S>& mesh);
#endif

}  // namespace pinball
