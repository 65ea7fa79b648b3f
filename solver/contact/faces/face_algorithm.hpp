#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/segments/edge_table.hpp>
#include <solver/contact/segments/segment_surface.hpp>
#include <solver/contact/spheres/sphere_surface.hpp>

#include "edge_rows.hpp"
#include "feature_lists.hpp"
#include "node_rows.hpp"
#include "sphere_rows.hpp"

namespace pinball {

/// The gap of faces as it is: nodes against faces, in both directions, and edges against edges, enforced by impulses.
/// Every pair of features that closes its gap within the step has a row of its own.
template <class S>
class FaceAlgorithm final : public ContactAlgorithm<S> {
 public:
  FaceAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source, InitialSurface start);

  void update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) override;
  bool work_with(std::unique_ptr<PinballKernels<S>>& kernels) override;
  std::span<const std::int32_t> read_nodes() const override { return read_nodes_; }
  std::int64_t choices_of_read_nodes() const override { return choices_; }
  bool looks_ahead() const override { return true; }
  void search(const SurfaceSource<S>& source, double dt) override;

  const char* name() const override { return "pinball"; }
  void add_node_forces(std::span<Point> node_force) const override;
  void put_radii(const SurfaceSource<S>& source, std::vector<double>& slot_radius) const override;
  const Surface& surface() const override { return surface_.topology(); }
  std::vector<std::int32_t> nodes() const override;
  ListSize listed() const override {
    return {std::ssize(surface_.slaves()) + spheres_.count(), lists_.entries(), lists_.places()};
  }
  void persist(StateArchive& archive, const SurfaceSource<S>& source) override;
  std::size_t bytes() const override;

 private:
  ContactWork spring_forces(const SurfaceSource<S>& /*source*/, S /*dt*/) override { return {}; }
  void add_spring_forces(const SurfaceSource<S>& /*source*/, ContactWork& /*work*/) override {}
  const std::vector<std::int32_t>& nodes_of_springs() override { return no_springs_; }
  void add_pair_forces_of_springs(std::vector<Point>& /*sums*/) const override {}
  void collect_impulses(const SurfaceSource<S>& source, double dt) override;
  double leap(const SurfaceSource<S>& source, double dt) const;
  /// Finds the rows of nodes and edges, with other processes if there are some.
  void find_rows(const SurfaceSource<S>& source, const StepReach& step);
  void note_depths();
  /// Whether the lists have all that may touch.
  bool lists_hold(const SurfaceSource<S>& source);
  /// Has the lists follow nodes that have strayed, if these are few; else they hold no longer.
  bool follow_strays(const SurfaceSource<S>& source);
  /// Has what is listed brought up to date in every step, and nothing else; notes the nodes of it.
  void choose_listed();
  /// The same of what has come to the lists.
  void choose_more();
  void choose_edge(std::int32_t edge);
  void choose_node(std::int32_t slave);
  void choose_face(std::int32_t segment);
  void finish_choice();
  /// Notes that the motion of a slave decides what touches; choose_more() adds it to the list of such nodes.
  void list_slave(std::int32_t slave);
  /// Notes that the motion of the corners of a segment is read, or of those around a slave.
  void read_corners(std::int32_t segment);
  void read_around(std::int32_t slave);
  void list_read_nodes();

  SegmentSurface<S> surface_;
  EdgeTable<S> edges_;
  SphereSurface<S> spheres_;
  std::vector<float> depth_;  ///< per node of the store: the deepest that it was in a row of the last step [length]
  std::vector<std::int32_t> deep_;  ///< nodes with such a depth
  FeatureLists<S> lists_;
  NodeRows<S> node_rows_;
  EdgeRows<S> edge_rows_;
  SphereRows<S> sphere_rows_;
  std::vector<std::byte> found_rows_;  ///< message
  std::vector<std::int32_t> no_springs_;
  std::vector<std::int32_t> listed_nodes_;      ///< of the store: all whose motion decides what touches
  std::vector<std::uint8_t> listed_slave_;      ///< per slave: among these
  bool adds_to_choice_ = false;                 ///< in choose_more()
  std::unique_ptr<PinballKernels<S>> kernels_;  ///< that look for nodes that stray; null: the host does
  bool kernels_outdated_ = true;                ///< others are expected elsewhere than these know
  // Only with kernels.
  std::vector<std::uint8_t> read_slave_;  ///< per slave: its numbers are read while the lists hold
  std::vector<std::int32_t> read_nodes_;  ///< of the store
  std::int64_t choices_ = 0;              ///< of them
  std::int32_t searches_since_ = 0;       ///< the surface changed, without a collection
};

}  // namespace pinball
