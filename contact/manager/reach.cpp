#include "contact/manager/reach.hpp"

#include "contact/manager/implementation.hpp"

namespace brunt {

namespace {
template <int Dim>
ContactNodeName name_of(const ContactNodes<Dim>& nodes, LocalIndex node) {
  const auto i = slot_of(node);
  return {nodes.surface[i], nodes.id[i]};
}
}  // namespace

template <int Dim>
ContactReaches<Dim> ContactManager<Dim>::reaches() const {
  auto& own = *implementation_;
  own.search.entities().refresh_unlisted_planes();
  const auto& entities = own.search.entities();
  ContactReaches<Dim> all;
  for (std::size_t f = 0; f < entities.faces.size(); ++f) {
    const auto& face = entities.faces[f];
    auto& one = all.faces.emplace_back();
    one.box = own.search.candidates().box_of_face(entities, f);
    one.id = face.id, one.rigid = face.everywhere, one.n_nodes = face.n_nodes;
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      one.node[c] = name_of(entities.nodes, face.node[c]);
    }
  }
  for (std::size_t p = 0; p < entities.particles.size(); ++p) {
    const auto& particle = entities.particles[p];
    auto& one = all.particles.emplace_back();
    one.box = own.search.candidates().box_of_particle(entities, p);
    one.id = particle.id, one.n_nodes = 1;
    one.node[0] = name_of(entities.nodes, particle.node);
  }
  for (const auto& pair : own.search.candidates().faces(entities).listed()) {
    ++all.faces[slot_of(pair.lower)].candidates;
  }
  const ParticleRows rows = own.search.candidates().particle_rows(own.setup.pairs, own.last.ahead);
  for (std::size_t row = 0; row < rows.row_clearances.size(); ++row) {
    const auto [first, last] = rows.range(row);
    all.particles[slot_of(rows.row_clearances[row].entity)].candidates += last - first;
  }
  for (const auto& pair : own.search.candidates().pairs()) {
    ++all.particles[slot_of(pair.particle)].candidates;
  }
  own.evaluation.records().visit([&](const ContactRecord<Dim>& record) {
    auto& touch = all.touches.emplace_back();
    touch.kind = record.kind;
    touch.evaluator = record.kind == ContactKind::face_face ? entities.face_with(record.first)
                                                            : entities.particle_with(record.first);
    for (std::size_t i = 0; i < slot_of(record.n_nodes); ++i) {
      touch.node.push_back(name_of(entities.nodes, record.node[i]));
    }
  });
  all.letter_bytes = sizeof(Contribution<Dim>) + sizeof(ContactNodeName);
  return all;
}

template ContactReaches<2> ContactManager<2>::reaches() const;
template ContactReaches<3> ContactManager<3>::reaches() const;

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
