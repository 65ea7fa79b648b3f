#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pinball {

/// Tiles as the nodes of a graph; two that share nodes of the mesh are neighbours.
struct TileGraph {
  std::vector<std::int32_t> first;      ///< [tiles + 1]: where the neighbours of a tile begin
  std::vector<std::int32_t> neighbour;  ///< tile after tile
  std::vector<std::int32_t> shared;     ///< nodes that the two share, beside `neighbour`
  std::vector<std::int32_t> work;       ///< per tile: work_of_tiles()
};

/// How tiles are given to ranks; no result depends on it.
struct Partition {
  enum class By {
    tiles,  ///< ranges of tiles in their order
    graph,  ///< the fewest nodes shared (METIS)
    random  ///< each tile by itself
  };
  By by = By::tiles;
  std::uint64_t seed = 0;  ///< of By::random
};

/// What goes to another rank, and what comes from there.
struct RankMessage {
  int rank = 0;
  std::span<const std::byte> sent;
  std::span<std::byte> received;
};

/// The processes that run one scene together, each with a number; rank 0 reads, decides and writes. All of them call
/// the same members in the same order. Here is no type of the library that carries the messages (mpi/).
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int number() const = 0;  ///< of this one
  virtual int count() const = 0;
  /// Of this one among those on its machine, in the order of their numbers.
  virtual int number_on_machine() const { return number(); }
  /// Whether messages may begin and end in the memory of a CUDA device.
  virtual bool reaches_cuda() const { return false; }
  /// Of the program that this rank runs: where two differ, so may what they compute.
  virtual std::uint64_t program() const = 0;

  /// From rank 0 to all.
  virtual void broadcast(std::span<std::byte> bytes) = 0;
  /// What each has, one after the other in `all`: to_all, or on rank 0 alone. bytes_of: of each rank.
  virtual void gather(std::span<const std::byte> own, const std::vector<std::size_t>& bytes_of,
                      std::span<std::byte> all, bool to_all) = 0;
  /// With each other rank at most one message.
  virtual void exchange(std::span<const RankMessage> messages) = 0;
  /// The part, 0 ... count() - 1, of each tile. Throws InputError where no partitioner was built.
  virtual std::vector<std::int32_t> cut(const TileGraph& tiles) const = 0;

  /// The others wait for what does not come any more: they are ended when this object goes, all with exit status 1.
  void give_up() { gave_up_ = true; }

  /// Of each number in `of`, what its owner has; owner: rank of each. wanted(i): whether the others need it, which all
  /// answer alike.
  template <class Value, class Wanted>
  void share(const std::vector<std::int32_t>& owner, Value* of, const Wanted& wanted) {
    std::vector<Value> own;
    std::vector<std::size_t> bytes_of(count(), 0), next(count(), 0);
    std::size_t shared = 0;
    for (std::size_t i = 0; i < owner.size(); ++i) {
      if (!wanted(i)) continue;
      ++shared;
      bytes_of[owner[i]] += sizeof(Value);
      if (owner[i] == number()) own.push_back(of[i]);
    }
    std::vector<Value> all(shared);
    for (std::size_t r = 1; r < next.size(); ++r) next[r] = next[r - 1] + bytes_of[r - 1] / sizeof(Value);
    gather(std::as_bytes(std::span(own)), bytes_of, std::as_writable_bytes(std::span(all)), true);
    for (std::size_t i = 0; i < owner.size(); ++i) {
      if (wanted(i)) of[i] = all[next[owner[i]]++];
    }
    bytes_given += static_cast<std::int64_t>(all.size() * sizeof(Value));
  }
  template <class Value>
  void share(const std::vector<std::int32_t>& owner, Value* of) {
    share(owner, of, [](std::size_t) { return true; });
  }

  Partition partition;
  /// Numbers that a loop has to look at for ranks to share it (Sharers).
  static constexpr std::int64_t worth_a_message_by_default = 4096;
  std::int64_t worth_a_message = worth_a_message_by_default;
  std::int64_t bytes_given = 0;  ///< by all ranks together, for sums in steps
  bool agreed = false;           ///< all have said whether they are ready (agree()),
  bool running = false;          ///< and were

 protected:
  bool gave_up_ = false;
};

/// What a rank has come to when its scene is built, or why it has not.
struct RankReady {
  int status = 0;                 ///< exit status; 0: it is ready
  std::string error;              ///< why not
  std::int32_t simd_width = 0;    ///< lanes of a pack
  std::uint64_t fingerprint = 0;  ///< of the model and its partition
};

/// To be called once by all ranks. Throws InputError or RunError, on rank 0 with the message of the lowest rank that
/// has failed or that has another program, packs or mesh than rank 0; a rank that has failed itself gets no other
/// error.
void agree(Ranks& ranks, const RankReady& own);

}  // namespace pinball
