// brunt with another partition (core/parallel/partition.hpp), which stands before that of the
// library: every point goes to a rank by a hash of its id and of how many partitions there were,
// near what it touches or not. Contact that is the same by bisection and by this does not lean on
// how pieces lie.
#include "core/parallel/partition.hpp"

namespace brunt {

namespace {
/// splitmix64: Steele, Lea & Flood 2014, fig. 16.
std::uint64_t mix(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}
}  // namespace

template <int Dim>
Partition make_partition(const Communicator& ranks, std::span<const Vec<Dim>> x,
                         std::span<const Real>, int parts) {
  static std::uint64_t partitions = 0;  // every rank partitions as often as the others
  ++partitions;
  const auto n = static_cast<std::uint64_t>(parts > 0 ? parts : ranks.size());
  Partition partition;
  for (std::uint64_t i = 0; i < x.size(); ++i) {
    partition.owner.push_back(static_cast<std::int32_t>(mix(i + (partitions << 40)) % n));
  }
  return partition;
}

template Partition make_partition<2>(const Communicator&, std::span<const Vec<2>>,
                                     std::span<const Real>, int);
template Partition make_partition<3>(const Communicator&, std::span<const Vec<3>>,
                                     std::span<const Real>, int);

}  // namespace brunt
