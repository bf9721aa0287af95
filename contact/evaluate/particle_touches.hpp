#pragma once
/// What particles remember of surfaces from one evaluation to the next.
#include "contact/evaluate/evaluate.hpp"

namespace brunt {

/// Where the touches of a particle begin, which are the last of them so far.
std::size_t first_touch_of(GlobalId particle, const std::vector<FirstTouch>& touches);

/// What a particle that is held by a face keeps of its surface waits until it is held no more.
template <int Dim>
void keep_touch(const ContactParticle& particle, const ContactFace<Dim>& face,
                const TouchStep& step, typename Records<Dim>::Part& part);

/// Where a particle was held by a body until now with `force` [N], its overlaps begin with that
/// force on a contact of `stiffness` [N/m]: what is deeper was closed against another spring, and
/// is felt once it has opened. Its own among part.particle_touches begin at `first`.
template <int Dim>
void begin_where_held(const ContactParticle& particle, Label body, const Vec<Dim>& force,
                      Real stiffness, std::size_t first, typename Records<Dim>::Part& part);

/// Says of the hits of a surface on which side of a thin plate the particle came in: faces that
/// look away from the one that held it are on the other. Where an evaluation is repeated, what it
/// kept is that face.
template <int Dim>
void recall_entries(const Entities<Dim>& entities, const ContactParticle& particle,
                    const TouchStep& step, std::vector<ParticleHit<Dim>>& hits);

/// Keeps the nearest face of each thin plate of elements that the particle touches.
/// first  its own among part.particle_touches begin here
template <int Dim>
void remember_entries(const Entities<Dim>& entities, const ContactParticle& particle,
                      const TouchStep& step, std::size_t first, typename Records<Dim>::Part& part);

/// Keeps the sides of open surfaces where the particle touches them.
template <int Dim>
void remember_sides(const ContactParticle& particle, std::size_t first,
                    typename Records<Dim>::Part& part);

/// Takes from the overlaps of the hits what their surfaces had at time 0, when the particle or the
/// face was born, or when it came back from where nothing held it, and have not opened since; then
/// begins with it.
template <int Dim>
void track_overlaps(const Entities<Dim>& entities, const ContactParticle& particle,
                    PairFinder& pairs, const TouchStep& step, typename Records<Dim>::Part& part);

}  // namespace brunt
