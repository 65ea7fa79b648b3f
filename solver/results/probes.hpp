#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/results.hpp>

namespace pinball {

/// The nodes and elements that [[probe]] tables watch: chosen once by their initial places or numbers, read
/// when a row is written.
template <class S>
class Probes {
 public:
  explicit Probes(const Model<S>& model);

  /// Names of the columns, PROBE_QUANTITY, in the order of values().
  std::vector<std::string> columns() const;
  /// What they read: nodes of the store and slots.
  std::vector<std::int32_t> nodes(const Model<S>& model) const;
  std::vector<std::int64_t> slots(const Model<S>& model) const;
  /// How far the position of a node of the store is ahead of the stresses [length].
  using WayAhead = std::function<Point(std::int32_t)>;
  std::vector<double> values(const Model<S>& model, const WayAhead& way_ahead) const;
  std::vector<ProbeResult> results(const Model<S>& model, const WayAhead& way_ahead) const;

 private:
  struct Watched {
    Probe probe;
    std::size_t number = 0;  ///< of the node or element in the scene
    std::string body;
    Point start{};  ///< of the node, or of the centre of the element [length]
  };
  void add_values(const Model<S>& model, const Watched& watched, const WayAhead& way_ahead,
                  std::vector<double>& values) const;

  std::vector<Watched> watched_;
};

}  // namespace pinball
