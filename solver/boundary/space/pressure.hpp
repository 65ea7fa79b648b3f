#pragma once

#include <kernels/boundary/face_pressure.hpp>

#include "boundary_kernels.hpp"
#include "loops.hpp"

namespace pinball {

template <class S, class Space>
class SpacePressure final : public PressureKernels<S> {
 public:
  /// place_of_slot: of elements in the arrays of the space; empty: they are the slots. sharing: of several ranks; null:
  /// one process has all faces.
  SpacePressure(const FaceList& faces, const std::vector<std::int64_t>& place_of_slot, SharedNodes* sharing)
      : sharing_(sharing),
        shared_(shared_list(sharing, faces.nodes.size(), [nodes = faces.nodes](std::int64_t i) { return nodes[i]; })),
        element_(list_in<Space>(places_of(faces.element, place_of_slot))),
        corners_(list_in<Space>(faces.corners)),
        nodes_(list_in<Space>(faces.nodes)),
        first_(list_in<Space>(faces.first)),
        places_(list_in<Space>(faces.places)),
        corner_force_(3 * faces.corners.size()),
        force_(3 * faces.nodes.size()) {
    if (sharing == nullptr) return;
    for (const std::int64_t slot : faces.element) rank_of_face_.push_back(sharing->rank_of_slot(slot));
  }

  void add(const NodeArrays<S>& nodes, S pressure) override {
    for_each<Space>("pressure", element_.size(),
                    PressFaces<S>{nodes, element_.data(), corners_.data(), pressure, corner_force_.data()});
    if (sharing_ != nullptr) share_forces();
    for_each<Space>(
        "force of pressure", node_count(),
        GatherPressure<S>{nodes, nodes_.data(), first_.data(), places_.data(), corner_force_.data(), force_.data()});
  }
  void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const override {
    add_sum<Space>("work of pressure", node_count(), WorkOfForces<S, PressureForce<S>>{nodes, forces(), step}, sum,
                   shared_);
  }
  VectorSum force() const override {
    VectorSum sum;
    add_sum<Space>("total of pressure", node_count(), TotalOfForces<S, PressureForce<S>>{{}, forces()}, sum);
    return sum;
  }
  std::size_t bytes() const override {
    return element_.bytes() + corners_.bytes() + nodes_.bytes() + first_.bytes() + places_.bytes() +
           corner_force_.bytes() + force_.bytes();
  }

 private:
  struct FaceForce {
    S number[12];
  };
  using Memory = typename Space::memory_space;
  static std::vector<std::int64_t> places_of(std::vector<std::int64_t> slots,
                                             const std::vector<std::int64_t>& place_of) {
    if (place_of.empty()) return slots;
    for (std::int64_t& slot : slots) slot = place_of[slot];
    return slots;
  }
  /// Who works the element has all corners of the face.
  void share_forces() {
    const auto share = [this](S* forces) { sharing_->share(rank_of_face_, reinterpret_cast<FaceForce*>(forces)); };
    if constexpr (on_host<Space>) {
      share(corner_force_.data());
    } else {
      std::vector<S> forces(corner_force_.size());
      deep_copy(forces.data(), corner_force_);
      share(forces.data());
      deep_copy(corner_force_, forces.data(), forces.size());
    }
  }
  PressureForce<S> forces() const { return {nodes_.data(), force_.data()}; }
  std::int64_t node_count() const { return nodes_.size(); }

  SharedNodes* sharing_;
  SharedList shared_;  ///< of nodes_
  std::vector<std::int32_t> rank_of_face_;
  Array<std::int64_t, Memory> element_;
  Array<std::int32_t, Memory> corners_, nodes_, first_, places_;  ///< FaceList
  Array<S, Memory> corner_force_;                                 ///< 4 x 3 per face [force]
  Array<S, Memory> force_;                                        ///< 3 per node [force]
};

}  // namespace pinball
