/// What friction needs to know of the materials on both sides of a contact.
#include <algorithm>

#include "contact/evaluate/evaluate.hpp"

namespace brunt {

namespace {
/// The side with the nodes `side` of a record; its temperature [K] is that of the point of contact
/// where the nodes keep it, else of the material that it shows.
template <int Dim>
SurfaceMaterial at_contact(const Entities<Dim>& entities, LocalIndex surface,
                           const SurfaceMaterial& shown, const ContactRecord<Dim>& record,
                           const ContactSide& side, const FrictionStep<Dim>& step) {
  SurfaceMaterial material = shown;
  if (!entities.conducts[slot_of(surface)]) return material;
  material.temperature = 0;
  for (int i = side.first; i < side.last; ++i) {
    const auto k = slot_of(i);
    const auto node = slot_of(record.node[k]);
    material.temperature += step.weight[k] * entities.nodes.temperature[node];
  }
  return material;
}

SurfaceMaterial of_both(const SurfaceMaterial& a, const SurfaceMaterial& b) {
  return {0.5 * (a.temperature + b.temperature), std::min(a.flow_stress, b.flow_stress)};
}
}  // namespace

template <int Dim>
void set_face_material(const Entities<Dim>& entities, const FaceCandidate& candidate,
                       const ContactRecord<Dim>& record, FrictionStep<Dim>& step) {
  if (!step.laws->friction->needs_material()) return;
  const auto l = slot_of(candidate.lower);
  const auto u = slot_of(candidate.upper);
  step.material = of_both(at_contact<Dim>(entities, entities.faces[l].surface,
                                          entities.materials[l], record, step.lower, step),
                          at_contact<Dim>(entities, entities.faces[u].surface,
                                          entities.materials[u], record, step.upper, step));
}

template <int Dim>
void set_particle_material(const Entities<Dim>& entities, const ContactParticle& particle,
                           LocalIndex face, const ContactRecord<Dim>& record,
                           FrictionStep<Dim>& step) {
  if (!step.laws->friction->needs_material()) return;
  const auto f = slot_of(face);
  const auto& shown = entities.nodes.material[slot_of(particle.node)];
  step.material =
      of_both(at_contact<Dim>(entities, entities.faces[f].surface, entities.materials[f], record,
                              step.lower, step),
              at_contact<Dim>(entities, particle.surface, shown, record, step.upper, step));
}

template <int Dim>
void set_pair_material(const Entities<Dim>& entities, const ContactParticle& first,
                       const ContactParticle& second, const ContactRecord<Dim>& record,
                       FrictionStep<Dim>& step) {
  if (!step.laws->friction->needs_material()) return;
  const auto shown = [&](const ContactParticle& particle) -> const SurfaceMaterial& {
    return entities.nodes.material[slot_of(particle.node)];
  };
  step.material =
      of_both(at_contact<Dim>(entities, first.surface, shown(first), record, step.lower, step),
              at_contact<Dim>(entities, second.surface, shown(second), record, step.upper, step));
}

template void set_face_material<2>(const Entities<2>&, const FaceCandidate&,
                                   const ContactRecord<2>&, FrictionStep<2>&);
template void set_face_material<3>(const Entities<3>&, const FaceCandidate&,
                                   const ContactRecord<3>&, FrictionStep<3>&);
template void set_particle_material<2>(const Entities<2>&, const ContactParticle&, LocalIndex,
                                       const ContactRecord<2>&, FrictionStep<2>&);
template void set_particle_material<3>(const Entities<3>&, const ContactParticle&, LocalIndex,
                                       const ContactRecord<3>&, FrictionStep<3>&);
template void set_pair_material<2>(const Entities<2>&, const ContactParticle&,
                                   const ContactParticle&, const ContactRecord<2>&,
                                   FrictionStep<2>&);
template void set_pair_material<3>(const Entities<3>&, const ContactParticle&,
                                   const ContactParticle&, const ContactRecord<3>&,
                                   FrictionStep<3>&);

}  // namespace brunt
// Tested by tests/verification/friction_law_test.cpp.
