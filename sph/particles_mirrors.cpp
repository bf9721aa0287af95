/// Mirror images of particles beyond planes of symmetry: a place in the lists and in the records
/// that sums read, behind those of all particles and of copies of other ranks', and nothing else.
/// docs/theory/sph.md, section 14.
#include <algorithm>

#include "sph/parallel.hpp"
#include "sph/particles.hpp"

namespace brunt {

/// [m] How far own particles have come through the planes that their sums lie on, on all ranks.
template <int Dim>
Real SphParticles<Dim>::depth_behind_mirrors() const {
  Real deepest = 0;
  for (std::size_t i = 0; i < n_owned(); ++i) {
    const MirrorAxes across = mirrors_.across(sum_[i]);
    for (int c = 0; c < Dim; ++c) {
      if (is_across(across, c)) {
        deepest = std::max(deepest, -mirrors_.distance(places()[i], c, sum_[i]));
      }
    }
  }
  return ranks_->max(deepest);
}

/// The planes within reach of a particle of a sum: farther away, its image is out of reach of all
/// that lies on its side of the plane.
/// reach  [m] the longest that another particle has, what lies behind the plane, and the skin
template <int Dim>
MirrorAxes SphParticles<Dim>::mirrors_near(std::size_t i, Label sum, Real reach) const {
  MirrorAxes near = mirrors_.across(sum);
  for (int c = 0; c < Dim; ++c) {
    if (!is_across(near, c)) continue;
    const Real away = mirrors_.distance(places()[i], c, sum);
    if (away > smoothing_length_[i] + reach) near &= ~(MirrorAxes{1} << c);
  }
  return near;
}

/// Calls f(axes) for each way of being reflected across some of the planes.
template <class F>
void for_each_reflection(MirrorAxes planes, const F& f) {
  for (MirrorAxes axes = 1; axes <= planes; ++axes) {
    if ((axes & ~planes) == 0) f(axes);
  }
}

template <int Dim>
MirrorAxes SphParticles<Dim>::mirrored(Label body) const {
  MirrorAxes axes = 0;
  for (std::size_t i = 0; i < n_owned() && mirrors_.any(); ++i) {
    if (points_.body[i] == body) axes |= mirrors_.across(sum_[i]);
  }
  return axes;
}

/// What a rank wants of others beside what is near its own particles: what their images would be
/// near to.
template <int Dim>
void SphParticles<Dim>::add_mirrored(std::vector<SearchBox<Dim>>& wanted, Real skin,
                                     Real reach) const {
  if (!mirrors_.any()) return;
  for (std::size_t i = 0; i < n_owned(); ++i) {
    for_each_reflection(mirrors_near(i, sum_[i], reach), [&](MirrorAxes axes) {
      const Vec<Dim> x = mirrors_.reflected(places()[i], axes);
      wanted.push_back(SearchBox<Dim>::about(x, smoothing_length_[i] + 0.5 * skin));
    });
  }
}

/// Images of all particles here, copies too, that may come within reach before the lists are
/// renewed; by their axes, then by the ids of what they are of: rows are in that order on any rank.
template <int Dim>
void SphParticles<Dim>::renew_images(Real reach) {
  images_.clear();
  if (!mirrors_.any()) return;
  const std::size_t n = points_.x.size();
  for (std::size_t i = 0; i < n; ++i) {
    for_each_reflection(mirrors_near(i, sum_[i], reach), [&](MirrorAxes axes) {
      images_.push_back({static_cast<LocalIndex>(i), axes});
    });
  }
  std::sort(images_.begin(), images_.end(), [this](const MirrorImage& a, const MirrorImage& b) {
    return a.axes != b.axes ? a.axes < b.axes : points_.id[a.of] < points_.id[b.of];
  });
  hold(n, n + images_.size());
  for (const MirrorImage& image : images_) sum_.push_back(sum_[image.of]);
  place_images();
}

/// Ids of all that lists hold: those of images come after all of particles.
template <int Dim>
std::vector<GlobalId> SphParticles<Dim>::ids_in_rows() const {
  constexpr int kIdBits = 48;
  std::vector<GlobalId> ids = points_.id;
  for (const MirrorImage& image : images_) {
    ids.push_back(GlobalId{image.axes} << kIdBits | points_.id[image.of]);
  }
  return ids;
}

/// True where no particle without an image can have come so near to a plane that its image would be
/// within reach: none has moved toward it by half of the skin.
template <int Dim>
bool SphParticles<Dim>::images_hold() const {
  if (!mirrors_.any()) return true;
  Real approach = 0, growth = 0;
  for (std::size_t i = 0; i < n_owned(); ++i) {
    const MirrorAxes across = mirrors_.across(sum_[i]);
    if (across == 0) continue;
    growth = std::max(growth, smoothing_length_[i] - watch_.reach()[i]);
    for (int c = 0; c < Dim; ++c) {
      if (!is_across(across, c)) continue;
      approach = std::max(approach, mirrors_.distance(watch_.x()[i], c, sum_[i]) -
                                        mirrors_.distance(places()[i], c, sum_[i]));
    }
  }
  return 2 * (approach + growth) <= watch_.skin();
}

template <int Dim>
void SphParticles<Dim>::place_images() {
  const std::size_t n = points_.x.size();
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const auto& [of, axes] = images_[k];
    place_[n + k] = mirrors_.reflected(place_[of], axes);
    smoothing_length_[n + k] = smoothing_length_[of];
  }
}

/// Of places, velocities, lengths, volumes and densities.
template <int Dim>
void SphParticles<Dim>::reflect_motion() {
  using Record = MotionRecord<Dim>;
  const std::size_t n = points_.x.size();
  for_each(images_.size(), [&](std::size_t k) {
    const auto& [of, axes] = images_[k];
    motion_[n + k] = motion_[of];
    for (int d = 0; d < Dim; ++d) motion_[n + k].data[d] = place_[n + k][d];
    reflect_vector<Dim>(axes, motion_[n + k].data + Record::kVelocity);
    constexpr int density = StressRecord<Dim>::kDensity;
    stress_[n + k].data[density] = stress_[of].data[density];
    if (!single_motion_.empty()) set_single_motion(n + k);
  });
}

/// Of stresses, once those of the step are known, of copies too.
template <int Dim>
void SphParticles<Dim>::reflect_stress() {
  const std::size_t n = points_.x.size();
  for_each(images_.size(), [&](std::size_t k) {
    const auto& [of, axes] = images_[k];
    stress_[n + k] = stress_[of];
    reflect_matrix<Dim>(axes, stress_[n + k].data);
    if (!artificial_.empty()) {
      artificial_[n + k] = artificial_[of];
      reflect_symmetric<Dim>(axes, artificial_[n + k].data);
    }
    if (any_total()) {
      total_record_[n + k] = total_record_[of];
      reflect_matrix<Dim>(axes, total_record_[n + k].data + TotalRecord<Dim>::kAffine);
    }
    if (still_.is_stirred(slot_of(of))) still_.stir(n + k);
  });
}

#define BRUNT_MIRRORS(Dim)                                               \
  template MirrorAxes SphParticles<Dim>::mirrored(Label) const;          \
  template Real SphParticles<Dim>::depth_behind_mirrors() const;         \
  template void SphParticles<Dim>::renew_images(Real);                   \
  template std::vector<GlobalId> SphParticles<Dim>::ids_in_rows() const; \
  template bool SphParticles<Dim>::images_hold() const;                  \
  template void SphParticles<Dim>::place_images();                       \
  template void SphParticles<Dim>::reflect_motion();                     \
  template void SphParticles<Dim>::reflect_stress();
BRUNT_MIRRORS(2)
BRUNT_MIRRORS(3)
#undef BRUNT_MIRRORS
template void SphParticles<2>::add_mirrored(std::vector<SearchBox<2>>&, Real, Real) const;
template void SphParticles<3>::add_mirrored(std::vector<SearchBox<3>>&, Real, Real) const;

}  // namespace brunt
// Tested by tests/verification/mirrored_particles_test.cpp.
