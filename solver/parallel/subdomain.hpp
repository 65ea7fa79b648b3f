#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <solver/contact/surface/surface.hpp>
#include <solver/model/model.hpp>
#include <solver/model/node_spans.hpp>

#include "common_nodes.hpp"
#include "corner_exchange.hpp"
#include "corner_plan.hpp"
#include "node_holders.hpp"
#include "rank_sharers.hpp"
#include "ranks.hpp"
#include "shared_blocks.hpp"
#include "shared_nodes.hpp"

namespace pinball {

/// What rank 0 asks the others to do with it.
enum class RankOrder : std::int32_t {
  step,    ///< the next one
  finish,  ///< the step without a length, at the end
  state,   ///< to send their part of the state
  answer,  ///< to do what was agreed on, with their part of the state (ask)
  end      ///< nothing more is to come
};

/// How a run is shared by ranks.
struct SharedWork {
  int ranks = 1;
  std::int64_t records = 0;          ///< forces of corners that all send in a step that works all elements
  std::int64_t messages = 0;         ///< in which they do, each of one rank to one other
  std::int64_t common_nodes = 0;     ///< that all ranks move
  std::int64_t bytes_per_step = 0;   ///< that all send in the last step; with subcycling the mean of its cycle
  std::int64_t most_elements = 0;    ///< of one rank
  double imbalance = 1;              ///< work of the rank that has most of it, over the mean (work_of_tiles)
  std::vector<std::string> devices;  ///< of each rank; empty: the host works all elements
};

/// The part of a scene that one of several ranks works: whole tiles. Each rank has the model of the whole scene; of
/// elements that are another's, and of nodes that it does not hold, the numbers are old until bring_back().
///
/// All ranks have the same numbers where sums are concerned: results of tiles, energies of spans, sums of boundary
/// conditions. So they choose the same steps, and find the same to be wrong.
template <class S>
class Subdomain final : public SharedNodes {
 public:
  Subdomain(const Model<S>& model, Ranks& ranks);
  /// On rank 0 lets the others go.
  ~Subdomain() override;
  Subdomain(const Subdomain&) = delete;  // what it has made points to it
  Subdomain& operator=(const Subdomain&) = delete;

  // ---- Before the first step ----

  // SharedNodes; where blocks() are asked for later than connect(), connect_sums() is to follow.
  std::shared_ptr<const SharedBlocks> blocks(std::int64_t count, SharedBlocks::Visit visit) override;
  std::int32_t rank_of_slot(std::int64_t slot) const override;
  std::int32_t rank() const { return ranks_.number(); }  ///< of this process
  std::int32_t ranks() const { return ranks_.count(); }
  std::int32_t rank_on_machine() const { return ranks_.number_on_machine(); }
  bool reaches_cuda() const { return ranks_.reaches_cuda(); }
  /// What the elements of this rank are worked by, for SharedWork.
  void set_device(const std::string& name) { device_ = name; }
  std::int32_t rank_of_tile(std::int64_t tile) const { return rank_of_tile_[tile]; }
  std::int32_t rank_of_node(std::int32_t node) const override {
    return node_blocks_->owner(block_of_span_[node / nodes_per_span]);
  }
  void keep_with_state(std::function<void()> bring) override { kept_.push_back(std::move(bring)); }
  /// Calls bring() before this rank gives others its part of the state: what brings it into the model.
  void bring_own_by(std::function<void()> bring) { bring_own_ = std::move(bring); }
  /// Nodes that all ranks are to move (CommonNodes).
  void add_common(std::span<const std::int32_t> nodes);
  /// All sums are known: who sends what to whom. Adds records to the nodes of the model. fingerprint: of the model.
  /// Throws where not all ranks are ready (agree()).
  void connect(Model<S>& model, std::uint64_t fingerprint);

  // ---- In a step ----

  bool works(std::int64_t tile) const { return rank_of_tile_[tile] == ranks_.number(); }
  void begin_cycle();
  void begin_step() {
    is_whole_ = false;
    ++steps_of_cycle_;
  }
  void end_cycle();
  /// Which forces cross between ranks; another one when plans() is another number.
  const CornerPlan& corner_plan() const { return *plan_; }
  std::int64_t plans() const { return plans_; }
  // Of ranks with a device each:
  bool has_common() const { return common_.any(); }
  /// Common nodes whose element forces this rank has; those of all others come by share_forces().
  const std::vector<std::int32_t>& own_common() const { return common_.own(); }
  void share_forces(NodeStore<S>& nodes) { common_.share_forces(nodes); }
  // Of ranks whose elements the host works:
  /// Nodes at the corners of elements as kernels see them (ElementView).
  const std::int32_t* corner() const { return corners_->corner(); }
  /// Of all tiles, from the next step on; with subcycling.
  void set_levels(const std::vector<int>& level_of_tile);
  void spread(NodeStore<S>& nodes, int level) const { corners_->spread(nodes, level); }
  /// level: the highest that was due.
  void collect(NodeStore<S>& nodes, int level) {
    corners_->collect(nodes, level);
    common_.share_forces(nodes);
  }
  /// With each other rank at most one message; bytes: of all that ranks send to each other in this.
  void exchange(std::span<const RankMessage> messages, std::int64_t bytes) {
    ranks_.exchange(messages);
    ranks_.bytes_given += bytes;
  }
  /// of_tile: what each tile has to tell; before, of the tiles of this rank, after, of all.
  template <class Value>
  void share_tiles(Value* of_tile) {
    share(rank_of_tile_, of_tile);
  }
  /// Which elements have eroded in the step: all ranks take them out. of_tile: how many, known to all.
  void share_eroded(Model<S>& model, const std::vector<std::int64_t>& of_tile);
  /// The same where each rank has a list of its own (slots); returns those of all, ascending.
  std::vector<std::int64_t> join_eroded(Model<S>& model, const std::vector<std::int64_t>& own);
  /// What all know to have eroded has no mass in the model, whoever has worked it.
  void take_out_eroded(Model<S>& model) const;
  /// Where elements have eroded since: the strains of the surface, from which contact guesses what erodes next.
  void share_strains(Model<S>& model, const Surface& surface);
  /// Nodes that are common from now on, with their motion and forces: those of new surface.
  void take_in(Model<S>& model, std::span<const std::int32_t> nodes);
  /// Motion and forces of all nodes, for what begins or ends now; connect_sums() when its sums are known.
  void bring_nodes(Model<S>& model);
  void connect_sums(Model<S>& model);
  /// Blocks of the sum of kinetic energies over all nodes: spans, of a run on a device pieces (sum_piece).
  const SharedBlocks& node_blocks() const { return *node_blocks_; }
  /// For loops over numbers that all have.
  Sharers& sharers() { return sharers_; }
  std::int32_t elements_of_tile(std::int64_t tile) const { return elements_of_tile_[tile]; }

  // ---- Between steps ----

  bool is_first() const { return ranks_.number() == 0; }
  /// Of rank 0; all others wait for it.
  void order(RankOrder order);
  RankOrder next_order();
  RankOrder last_order() const { return order_; }
  /// On rank 0, and in a step on all ranks, the state of the whole model, where steps have changed it. Elsewhere this
  /// does nothing.
  void bring_back(Model<S>& model);
  /// In a step: what was brought back is about to change.
  void go_on() { is_whole_ = false; }
  void send_state(Model<S>& model);  ///< at RankOrder::state
  /// Brings what this rank works into the model; what is another's may be old there.
  void bring_own() const {
    if (bring_own_) bring_own_();
  }
  /// On rank 0: all call act(number) and say what it returns, in the order of the ranks. The others: at
  /// RankOrder::answer.
  std::vector<std::string> ask(std::int64_t number, const std::function<std::string(std::int64_t)>& act);
  void state_was_read(Model<S>& model);

  SharedWork work() const;
  std::size_t bytes() const;

 private:
  bool moves(std::int64_t node) const { return holders_.has(node, ranks_.number()) || common_.has(node); }
  void share_devices();
  void cut_nodes(std::int32_t nodes);
  std::pair<std::int64_t, std::int64_t> nodes_of_block(std::int64_t block) const;
  void find_worked();
  void gather_state(Model<S>& model, bool to_all);
  void gather_nodes(std::initializer_list<Array<S>*> arrays, bool to_all);
  template <class E, class Range>
  void gather_ranges(Array<E>& array, const std::vector<std::int32_t>& owner, const Range& range, bool to_all);

  std::vector<std::int32_t> elements_of_tile_, work_of_tile_, rank_of_tile_;
  std::vector<std::int64_t> tile_packs_;  ///< Model::tile_packs
  int pack_width_;
  NodeHolders holders_;
  CommonNodes<S> common_;
  RankSharers sharers_;
  std::vector<std::uint8_t> is_alive_;  ///< per slot: the element of it, as all ranks know
  bool has_eroded_ = false;             ///< any, since share_strains()
  std::vector<std::shared_ptr<SharedBlocks>> blocks_;
  std::vector<std::int32_t> block_of_span_;  ///< of nodes
  std::vector<std::int64_t> end_of_block_;   ///< node behind the last of each
  std::shared_ptr<const SharedBlocks> node_blocks_;
  bool on_device_;                            ///< elements and nodes are worked by one
  std::optional<CornerPlan> plan_;            ///< from connect() on
  std::int64_t plans_ = 0;                    ///< that were made
  std::optional<CornerExchange<S>> corners_;  ///< from connect() on; not on a device
  std::vector<int> level_of_tile_;            ///< set_levels(); empty: all tiles are of one
  std::vector<std::function<void()>> kept_;
  std::function<void()> bring_own_;
  std::string device_;
  std::vector<std::string> devices_;  ///< of all ranks
  RankOrder order_ = RankOrder::end;
  bool connected_ = false;
  bool in_step_ = false;
  bool waits_ = false;    ///< messages are on their way
  bool is_whole_ = true;  ///< the model has the state of all ranks
  std::int64_t bytes_before_ = 0, bytes_per_step_ = 0;
  std::int64_t steps_of_cycle_ = 0;
};

}  // namespace pinball
