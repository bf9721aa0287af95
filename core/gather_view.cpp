#include "core/gather_view.hpp"

#include "core/merge_views.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
void pack(Packer& packer, const std::vector<Field>& fields) {
  packer << static_cast<std::uint64_t>(fields.size());
  for (const auto& field : fields) packer << field.name << field.components << field.values;
}

std::vector<Field> unpack_fields(Unpacker& from) {
  std::uint64_t n = 0;
  from >> n;
  std::vector<Field> fields(n);
  for (auto& field : fields) from >> field.name >> field.components >> field.values;
  return fields;
}

Bytes pack(const BodyView& view) {
  Packer packer;
  packer << view.position << view.connectivity << view.corners << view.cell_dimension;
  pack(packer, view.point_fields);
  pack(packer, view.cell_fields);
  packer << view.point_mass << view.point_radius << view.cell_volume << view.point_owned;
  return packer.take();
}

BodyView unpack(const Bytes& bytes) {
  BodyView view;
  Unpacker from(bytes);
  from >> view.position >> view.connectivity >> view.corners >> view.cell_dimension;
  view.point_fields = unpack_fields(from);
  view.cell_fields = unpack_fields(from);
  from >> view.point_mass >> view.point_radius >> view.cell_volume >> view.point_owned;
  return view;
}

}  // namespace

BodyView gather_view(BodyView mine, const Communicator& ranks) {
  if (ranks.alone()) return mine;
  std::vector<BodyView> parts;
  for (const Bytes& bytes : ranks.gather(pack(mine))) parts.push_back(unpack(bytes));
  BodyView view = merge_views(parts);
  view.body = mine.body, view.time = mine.time;
  return view;
}

}  // namespace brunt
// Tested by tests/verification/storage_order_test.cpp.
