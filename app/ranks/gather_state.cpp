#include "app/ranks/gather_state.hpp"

#include "core/parallel/packing.hpp"

namespace brunt {

std::vector<StateTable> of_all_ranks(const std::vector<StateTable>& mine,
                                     const Communicator& ranks) {
  Packer packer;
  for (const auto& table : mine) packer << table.name << table.width << table.id << table.value;
  std::vector<StateTable> all;
  for (const Bytes& bytes : ranks.all_gather(packer.take())) {
    Unpacker from(bytes);
    while (!from.done()) {
      auto& table = all.emplace_back();
      from >> table.name >> table.width >> table.id >> table.value;
    }
  }
  return all;
}

}  // namespace brunt
