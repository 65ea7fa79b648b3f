#pragma once

#include <cstddef>
#include <memory>

#include <kernels/boundary/node_arrays.hpp>

#include "device_mesh.hpp"
#include "element_totals.hpp"

namespace pinball {

/// The loops of a step whose arrays lie in the memory of an execution space. Between two calls nothing but what they
/// return crosses over; the state does when it is asked for.
template <class S>
class DeviceStep {
 public:
  virtual ~DeviceStep() = default;

  virtual void write(const DeviceState<S>& state) = 0;  ///< from the host
  virtual void read(DeviceState<S>& state) const = 0;   ///< to the host

  /// Stresses and corner forces of all elements; dt: the step just made [time].
  virtual ElementTotals<S> update_elements(S dt) = 0;
  /// What boundary conditions work on; good until the next write().
  virtual NodeArrays<S> nodes() = 0;
  /// Sums of the corner forces into those of the nodes, for those who add to them before nodes are integrated.
  virtual void sum_corner_forces() = 0;
  /// Velocities and positions of all nodes, and zero forces (node_update.hpp); sums the corner forces first where
  /// sum_corner_forces has not been called. Returns the kinetic energy at the time of the forces [energy].
  virtual double integrate(const StepLengths& step) = 0;

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
