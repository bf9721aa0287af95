#include "contact/contacts/face_tractions.hpp"

#include <utility>

namespace brunt {

template <int Dim>
TractionSum<Dim>::TractionSum(Entities<Dim>& entities, std::vector<TractionShare<Dim>> elsewhere)
    : entities_(entities), elsewhere_(std::move(elsewhere)) {
  area_before_.reserve(entities_.tractions.size());
  for (auto& traction : entities_.tractions) {
    area_before_.push_back(traction.area);
    traction = {};
  }
}

template <int Dim>
void TractionSum<Dim>::add(const ContactRecord<Dim>& record, const Friction<Dim>& friction) {
  if (record.kind != ContactKind::face_face) return;
  while (next_ < elsewhere_.size() && elsewhere_[next_].key < friction.key) add_next();
  add(slot_of(record.first_place), friction.area, -friction.slider());
  add(slot_of(record.second_place), friction.area, friction.slider());
}

template <int Dim>
void TractionSum<Dim>::finish() {
  while (next_ < elsewhere_.size()) add_next();
  for (std::size_t f = 0; f < area_before_.size(); ++f) {
    auto& traction = entities_.tractions[f];
    if (!(area_before_[f] > 0 && traction.area > 0)) continue;
    traction.growth = traction.area / area_before_[f];
  }
}

template <int Dim>
void TractionSum<Dim>::add(std::size_t face, Real area, const Vec<Dim>& force) {
  if (entities_.faces[face].rigid()) return;  // on several ranks nobody has all of its contacts
  auto& traction = entities_.tractions[face];
  traction.area += area;
  traction.force += force;
}

template <int Dim>
void TractionSum<Dim>::add_next() {
  const auto& share = elsewhere_[next_++];
  add(entities_.face_with(share.key.second), share.area, Vec<Dim>(share.force));
}

template <int Dim>
KeyedMemory<FaceGrowth> growths_of(const Entities<Dim>& entities) {
  KeyedMemory<FaceGrowth> growths;
  for (std::size_t f = 0; f < entities.tractions.size(); ++f) {
    const auto& face = entities.faces[f];
    const Real growth = entities.tractions[f].growth;
    if (face.owned && growth != 1) growths.add({{ContactKind::face_face, 0, face.id, 0}, growth});
  }
  return growths;
}

template <int Dim>
void take_growths(const KeyedMemory<FaceGrowth>& growths, Entities<Dim>& entities) {
  for (auto& traction : entities.tractions) traction.growth = 1;
  for (const auto& one : growths) {
    entities.tractions[entities.face_with(one.key.first)].growth = one.growth;
  }
}

template class TractionSum<2>;
template class TractionSum<3>;
template KeyedMemory<FaceGrowth> growths_of<2>(const Entities<2>&);
template KeyedMemory<FaceGrowth> growths_of<3>(const Entities<3>&);
template void take_growths<2>(const KeyedMemory<FaceGrowth>&, Entities<2>&);
template void take_growths<3>(const KeyedMemory<FaceGrowth>&, Entities<3>&);

}  // namespace brunt
// Tested by tests/unit/contact/friction_test.cpp.
