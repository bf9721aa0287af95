#include "core/parallel/communicator.hpp"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <cstdlib>

#include "core/errors.hpp"
#include "core/parallel/instruction_set.hpp"

namespace brunt {

namespace {
constexpr int kTag = 17;

/// A message longer than this goes in several: MPI counts in int.
constexpr std::size_t kLongest = std::size_t{1} << 30;

void check(int status, const char* what) {
  if (status != MPI_SUCCESS) throw MachineError(std::string("MPI: ") + what + " failed");
}

void post(std::span<const Message> messages, std::vector<MPI_Request>& requests) {
  for (const auto& message : messages) {
    for (std::size_t at = 0; at < message.receive.size(); at += kLongest) {
      const auto part = static_cast<int>(std::min(kLongest, message.receive.size() - at));
      requests.emplace_back();
      check(MPI_Irecv(message.receive.data() + at, part, MPI_BYTE, message.rank, kTag,
                      MPI_COMM_WORLD, &requests.back()),
            "receive");
    }
  }
  for (const auto& message : messages) {
    for (std::size_t at = 0; at < message.send.size(); at += kLongest) {
      const auto part = static_cast<int>(std::min(kLongest, message.send.size() - at));
      requests.emplace_back();
      check(MPI_Isend(message.send.data() + at, part, MPI_BYTE, message.rank, kTag, MPI_COMM_WORLD,
                      &requests.back()),
            "send");
    }
  }
}
}  // namespace

namespace {
/// Adds its life time to a count of seconds.
class Waiting {
 public:
  explicit Waiting(double& seconds) : seconds_(seconds) {}
  ~Waiting() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};
}  // namespace

BRUNT_ON_ANY_CPU bool launched_by_mpirun() {
  return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr ||
         std::getenv("PMIX_RANK") != nullptr;
}

void Communicator::trade(std::span<const Message> messages) const {
  const Waiting waiting(traffic_.seconds);
  std::vector<MPI_Request> requests;
  requests.reserve(2 * messages.size());
  for (const auto& message : messages) {
    if (message.send.empty()) continue;
    ++traffic_.messages;
    traffic_.bytes += static_cast<std::int64_t>(message.send.size());
  }
  post(messages, requests);
  check(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE),
        "wait");
}

std::vector<Bytes> Communicator::exchange(const std::vector<Bytes>& to) const {
  if (alone()) return to;
  const auto n = slot_of(size_);
  std::vector<std::uint64_t> sizes(n), coming(n);
  for (std::size_t r = 0; r < n; ++r) sizes[r] = to[r].size();
  {
    const Waiting waiting(traffic_.seconds);
    check(
        MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, coming.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD),
        "exchange of sizes");
  }
  ++traffic_.reductions;
  std::vector<Bytes> from(n);
  std::vector<Message> messages;
  for (std::size_t r = 0; r < n; ++r) {
    if (static_cast<int>(r) == rank_) {
      from[r] = to[r];
      continue;
    }
    from[r].resize(coming[r]);
    if (sizes[r] || coming[r]) messages.push_back({static_cast<int>(r), to[r], from[r]});
  }
  trade(messages);
  return from;
}

std::vector<Bytes> Communicator::exchange(std::span<const int> peers,
                                          std::span<const Bytes> to) const {
  std::vector<std::uint64_t> sizes(peers.size()), coming(peers.size());
  std::vector<Message> messages;
  for (std::size_t p = 0; p < peers.size(); ++p) {
    sizes[p] = to[p].size();
    messages.push_back({peers[p], std::as_bytes(std::span(&sizes[p], 1)),
                        std::as_writable_bytes(std::span(&coming[p], 1))});
  }
  trade(messages);
  std::vector<Bytes> from(peers.size());
  for (std::size_t p = 0; p < peers.size(); ++p) {
    from[p].resize(coming[p]);
    messages[p] = {peers[p], to[p], from[p]};
  }
  trade(messages);
  return from;
}

std::vector<Bytes> Communicator::all_gather(const Bytes& mine) const {
  return exchange(std::vector<Bytes>(slot_of(size_), mine));
}

std::vector<Bytes> Communicator::gather(const Bytes& mine) const {
  std::vector<Bytes> to(slot_of(size_));
  to[0] = mine;
  auto from = exchange(to);
  if (!is_root()) from.clear();
  return from;
}

/// Binomial tree to rank 0, then a broadcast: 2 log2(n) messages deep, any size of value.
void Communicator::reduce_bytes(std::span<std::byte> value, const CombineBytes& combine) const {
  const Waiting waiting(traffic_.seconds);
  ++traffic_.reductions;
  const auto count = static_cast<int>(value.size());
  Bytes other(value.size());
  for (int step = 1; step < size_; step *= 2) {
    if (rank_ % (2 * step) != 0) {
      check(MPI_Send(value.data(), count, MPI_BYTE, rank_ - step, kTag + 1, MPI_COMM_WORLD),
            "reduction");
      break;
    }
    if (rank_ + step >= size_) continue;
    check(MPI_Recv(other.data(), count, MPI_BYTE, rank_ + step, kTag + 1, MPI_COMM_WORLD,
                   MPI_STATUS_IGNORE),
          "reduction");
    combine(value.data(), other.data());
  }
  check(MPI_Bcast(value.data(), count, MPI_BYTE, 0, MPI_COMM_WORLD), "reduction");
}

void Communicator::max(std::span<Real> values) const {
  if (alone() || values.empty()) return;
  const Waiting waiting(traffic_.seconds);
  ++traffic_.reductions;
  check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE,
                      MPI_MAX, MPI_COMM_WORLD),
        "reduction");
}

ParallelSession::ParallelSession(int& argc, char**& argv) {
  int started = 0, provided = 0;
  MPI_Initialized(&started);
  leaves_ = started == 0;
  if (!launched_by_mpirun()) return;
  if (started == 0) check(MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided), "start");
  check(MPI_Comm_rank(MPI_COMM_WORLD, &ranks_.rank_), "rank");
  check(MPI_Comm_size(MPI_COMM_WORLD, &ranks_.size_), "size");
  end_where_features_miss(0);  // here nothing misses, or this would not run
}

ParallelSession::~ParallelSession() {
  int started = 0;
  MPI_Initialized(&started);
  if (started != 0 && leaves_) MPI_Finalize();
}

void ParallelSession::abort(int status) const {
  int started = 0;
  MPI_Initialized(&started);
  if (started && !ranks_.alone()) MPI_Abort(MPI_COMM_WORLD, status);
  std::_Exit(status);
}

const Communicator& lone_rank() {
  static const Communicator lone;
  return lone;
}

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
