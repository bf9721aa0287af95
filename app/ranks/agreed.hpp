#pragma once
#include <string>
#include <type_traits>

#include "core/errors.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

/// Runs on every rank what may fail on some of them, an action that gives Bytes or nothing, and
/// returns what it gave on each rank. Where one failed with a MachineError, all ranks throw that of
/// the first. Collective.
template <class Action>
std::vector<Bytes> agreed(const Communicator& ranks, const Action& action) {
  std::string failure;
  Bytes result;
  try {
    if constexpr (std::is_void_v<decltype(action())>) {
      action();
    } else {
      result = action();
    }
  } catch (const MachineError& error) {
    failure = error.what();
  }
  std::vector<Bytes> results;
  std::string first_failure;
  for (const Bytes& bytes : ranks.all_gather((Packer() << failure << result).take())) {
    Unpacker from(bytes);
    from >> failure >> results.emplace_back();
    if (first_failure.empty()) first_failure = failure;
  }
  if (!first_failure.empty()) throw MachineError(first_failure);
  return results;
}

}  // namespace brunt
