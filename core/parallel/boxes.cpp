#include "core/parallel/boxes.hpp"

#include <algorithm>

#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// Runs that a rank shows: 48 bytes each, and so many tests a box that is near.
constexpr std::size_t kRuns = 128;
}  // namespace

template <int Dim>
std::vector<SearchBox<Dim>> runs_of(std::span<const SearchBox<Dim>> boxes) {
  std::vector<SearchBox<Dim>> runs;
  const std::size_t n = boxes.size(), count = std::min(n, kRuns);
  for (std::size_t r = 0; r < count; ++r) {
    const std::size_t first = n * r / count, last = n * (r + 1) / count;
    runs.push_back(boxes[first]);
    for (std::size_t i = first + 1; i < last; ++i) runs.back().enclose(boxes[i]);
  }
  return runs;
}

template <int Dim>
std::vector<LocalIndex> meeting(std::span<const SearchBox<Dim>> boxes,
                                std::span<const SearchBox<Dim>> runs) {
  std::vector<LocalIndex> list;
  if (runs.empty()) return list;
  SearchBox<Dim> all = runs.front();
  for (const auto& run : runs) all.enclose(run);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].meets(all)) continue;
    const bool near = std::any_of(runs.begin(), runs.end(),
                                  [&](const SearchBox<Dim>& run) { return boxes[i].meets(run); });
    if (near) list.push_back(static_cast<LocalIndex>(i));
  }
  return list;
}

template <int Dim>
std::vector<std::vector<LocalIndex>> who_wants(const Communicator& ranks,
                                               std::span<const SearchBox<Dim>> offered,
                                               std::span<const SearchBox<Dim>> wanted) {
  std::vector<std::vector<LocalIndex>> lists(slot_of(ranks.size()));
  const auto shown = ranks.all_gather((Packer() << runs_of<Dim>(wanted)).take());
  for (std::size_t r = 0; r < lists.size(); ++r) {
    std::vector<SearchBox<Dim>> runs;
    Unpacker(shown[r]) >> runs;
    if (static_cast<int>(r) != ranks.rank()) lists[r] = meeting<Dim>(offered, runs);
  }
  return lists;
}

template std::vector<SearchBox<2>> runs_of<2>(std::span<const SearchBox<2>>);
template std::vector<SearchBox<3>> runs_of<3>(std::span<const SearchBox<3>>);
template std::vector<LocalIndex> meeting<2>(std::span<const SearchBox<2>>,
                                            std::span<const SearchBox<2>>);
template std::vector<LocalIndex> meeting<3>(std::span<const SearchBox<3>>,
                                            std::span<const SearchBox<3>>);
template std::vector<std::vector<LocalIndex>> who_wants<2>(const Communicator&,
                                                           std::span<const SearchBox<2>>,
                                                           std::span<const SearchBox<2>>);
template std::vector<std::vector<LocalIndex>> who_wants<3>(const Communicator&,
                                                           std::span<const SearchBox<3>>,
                                                           std::span<const SearchBox<3>>);

}  // namespace brunt
// Tested by tests/unit/core/partition_test.cpp.
