#pragma once
#include <span>
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/search/search.hpp"

namespace brunt {

/// Bounds of about equal runs of the boxes that a rank wants, at most 128: what it shows others.
/// boxes  closed [m], neighbours in the list near each other
template <int Dim>
std::vector<SearchBox<Dim>> runs_of(std::span<const SearchBox<Dim>> boxes);

/// Which of the boxes overlap any of the runs, ascending.
template <int Dim>
std::vector<LocalIndex> meeting(std::span<const SearchBox<Dim>> boxes,
                                std::span<const SearchBox<Dim>> runs);

/// For each rank, which of the boxes offered here overlap what that rank wants. Ranks show each
/// other the bounds of runs of their wanted boxes, not all of them: neighbours in the list lie near
/// each other along the curve, so little that is not needed gets through. Own rank: none.
/// offered, wanted  closed boxes [m]. Collective.
template <int Dim>
std::vector<std::vector<LocalIndex>> who_wants(const Communicator& ranks,
                                               std::span<const SearchBox<Dim>> offered,
                                               std::span<const SearchBox<Dim>> wanted);

}  // namespace brunt
