#include <pinball/solver/held_directions.hpp>

namespace pinball {

template <class S>
HeldDirections::HeldDirections(const Model<S>& model) : first_(model.node_mass.size() + 1, 0) {
  std::vector<std::vector<Point>> of_node(model.node_mass.size());
  const auto hold = [&of_node](std::int32_t node, const S* n) {
    of_node[static_cast<std::size_t>(node)].push_back(
        {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])});
  };
  for (const NodeConstraint<S>& c : model.constraints) hold(c.node, c.normal);
  for (const NodePrescription<S>& p : model.prescribed) hold(p.node, p.normal);
  for (std::size_t n = 0; n < of_node.size(); ++n) {
    directions_.insert(directions_.end(), of_node[n].begin(), of_node[n].end());
    first_[n + 1] = static_cast<std::int32_t>(directions_.size());
  }
}

template HeldDirections::HeldDirections(const Model<double>&);
template HeldDirections::HeldDirections(const Model<float>&);

}  // namespace pinball
