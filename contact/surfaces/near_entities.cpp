/// Which faces and nodes belong to bodies that may touch something, and which are new.
#include <vector>

#include "contact/surfaces/entities.hpp"

namespace brunt {

template <int Dim>
void Entities<Dim>::drop_imports() {
  if (nodes.size() > own_nodes_) nodes.shorten(own_nodes_);
  const auto dropped = std::erase_if(faces, [](const auto& face) { return face.facet < 0; }) +
                       std::erase_if(particles, [](const auto& one) { return !one.owned; });
  if (dropped == 0) return;
  shallowest = kInfinity;
  add_faces({});
}

template <int Dim>
void Entities<Dim>::begin_motion(const std::vector<Surface<Dim>*>& surfaces) {
  drop_imports();
  nodes.begin_motion(surfaces);
  shapes.clear();
}

template <int Dim>
void Entities<Dim>::choose(const std::vector<char>& of_bodies) {
  near = of_bodies;
  find_near();
}

template <int Dim>
void Entities<Dim>::find_near() {
  near_faces.clear();
  std::vector<char> of_node(nodes.size(), near.empty() ? 1 : 0);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& face = faces[f];
    if (!is_near(face.body)) continue;
    near_faces.push_back(static_cast<LocalIndex>(f));
    for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
      of_node[slot_of(face.node[c])] = 1;
    }
  }
  listed_faces = near_faces;
  clear_lists();
  for (const auto& particle : particles) {
    if (is_near(particle.body)) of_node[slot_of(particle.node)] = 1;
  }
  nodes.choose(of_node);
}

template <int Dim>
void Entities<Dim>::end_births() {
  for (auto& face : faces) face.born = false;
  for (auto& particle : particles) particle.born = false;
  any_born = false;
}

template void Entities<2>::drop_imports();
template void Entities<3>::drop_imports();
template void Entities<2>::begin_motion(const std::vector<Surface<2>*>&);
template void Entities<3>::begin_motion(const std::vector<Surface<3>*>&);
template void Entities<2>::end_births();
template void Entities<3>::end_births();
template void Entities<2>::choose(const std::vector<char>&);
template void Entities<3>::choose(const std::vector<char>&);
template void Entities<2>::find_near();
template void Entities<3>::find_near();

}  // namespace brunt
// Tested by tests/unit/contact/near_bodies_test.cpp.
