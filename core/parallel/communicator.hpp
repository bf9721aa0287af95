#pragma once
/// The ranks of a run, as the rest of brunt sees them. mpi.h stays in core/parallel/*.cpp.
#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/types.hpp"

namespace brunt {

using Bytes = std::vector<std::byte>;

/// What one rank sends to another, and what it expects from it; sizes are known on both sides.
struct Message {
  int rank = 0;
  std::span<const std::byte> send;
  std::span<std::byte> receive;
};

/// How much has gone between ranks since the start, for summary.json.
struct Traffic {
  std::int64_t messages = 0;    ///< sent from rank to rank
  std::int64_t bytes = 0;       ///< in them
  std::int64_t reductions = 0;  ///< in which all ranks took part
  double seconds = 0;           ///< of wall time in which this rank sent, received and waited
};

/// All calls are collective: every rank makes them in the same order. A lone rank starts no MPI and
/// gets back what it gave.
class Communicator {
 public:
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool alone() const { return size_ == 1; }
  bool is_root() const { return rank_ == 0; }

  /// Combines one value a rank, in an order that depends on nothing but the number of ranks;
  /// `combine(into, from)` must be free of order. Every rank gets the result.
  template <class T, class Combine>
  T reduce(T value, Combine combine) const {
    reduce_all(std::span<T>(&value, 1), combine);
    return value;
  }
  /// The same for each of several values, in one message; all ranks pass as many.
  template <class T, class Combine>
  void reduce_all(std::span<T> values, Combine combine) const {
    static_assert(std::is_trivially_copyable_v<T>);
    if (alone() || values.empty()) return;
    auto call = [&](std::byte* into, const std::byte* from) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        T a, b;
        std::memcpy(&a, into + k * sizeof(T), sizeof(T));
        std::memcpy(&b, from + k * sizeof(T), sizeof(T));
        combine(a, b);
        std::memcpy(into + k * sizeof(T), &a, sizeof(T));
      }
    };
    reduce_bytes(std::as_writable_bytes(values), call);
  }
  bool any(bool mine) const {
    return reduce(mine, [](bool& a, bool b) { a = a || b; });
  }
  /// Waits until all ranks are here.
  void barrier() const { any(false); }
  /// The largest of each value over all ranks.
  void max(std::span<Real> values) const;
  Real max(Real mine) const {
    return reduce(mine, [](Real& a, Real b) { a = b > a ? b : a; });
  }
  std::uint64_t sum(std::uint64_t mine) const {
    return reduce(mine, [](std::uint64_t& a, std::uint64_t b) { a += b; });
  }

  /// Sends to[r] to rank r; returns what each rank sent here.
  std::vector<Bytes> exchange(const std::vector<Bytes>& to) const;
  /// Sends to[p] to rank peers[p]; returns what each of them sent here. Collective among peers: a
  /// rank is a peer of those that are its peers.
  std::vector<Bytes> exchange(std::span<const int> peers, std::span<const Bytes> to) const;
  /// What every rank gave, on every rank.
  std::vector<Bytes> all_gather(const Bytes& mine) const;
  /// What every rank gave, on the root; nothing elsewhere.
  std::vector<Bytes> gather(const Bytes& mine) const;
  /// Messages among neighbours, all at once; at most one to and from each rank.
  void trade(std::span<const Message> messages) const;

  const Traffic& traffic() const { return traffic_; }

 private:
  friend class ParallelSession;
  using CombineBytes = std::function<void(std::byte* into, const std::byte* from)>;
  void reduce_bytes(std::span<std::byte> value, const CombineBytes& combine) const;

  int rank_ = 0, size_ = 1;
  mutable Traffic traffic_;
};

/// Joins the ranks that mpirun started, if it did; leaves them at its end. One at a time; another
/// one within its life, or within that of a program that called MPI_Init itself, leaves nothing.
class ParallelSession {
 public:
  ParallelSession(int& argc, char**& argv);
  ~ParallelSession();
  ParallelSession(const ParallelSession&) = delete;
  ParallelSession& operator=(const ParallelSession&) = delete;
  const Communicator& ranks() const { return ranks_; }
  /// Ends all ranks at once with an exit status: for what only one rank knows.
  [[noreturn]] void abort(int status) const;

 private:
  Communicator ranks_;
  bool leaves_ = true;  // nobody had called MPI_Init before
};

/// True where a launcher of MPI programs started this process.
bool launched_by_mpirun();

/// A rank by itself, for tests and for tools.
const Communicator& lone_rank();

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
