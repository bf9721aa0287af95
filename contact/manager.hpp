#pragma once
#include <memory>
#include <string>
#include <vector>

#include "contact/options.hpp"
#include "core/ledger.hpp"
#include "core/solid.hpp"
#include "core/step_vote.hpp"
#include "core/surface.hpp"
#include "core/view.hpp"

namespace brunt {

/// What history.csv prints of one pair of bodies; sums are exact.
struct PairReport {
  std::string name;              ///< the deck's, or "a-b"
  std::array<Real, 3> force{};   ///< [N] on the first body
  Real area = 0;                 ///< [m^2] of planes under pressure, or dp^(Dim-1) a particle contact
  Real max_penetration = 0;      ///< [m]
  std::int64_t planes = 0;       ///< common planes and particle contacts that carry force
};

/// The one contact manager: automatic pairing of all surfaces, common planes for face on face, the
/// corrected penalty for particle on face. Adds nodal forces in the order of keys.
template <int Dim>
class ContactManager {
 public:
  /// surfaces stay owned by their solids and outlive the manager; body_names by label.
  ContactManager(ContactOptions options, Geometry geometry, std::vector<Surface<Dim>*> surfaces,
                 std::vector<std::string> body_names);
  ~ContactManager();

  /// Votes before the step, from each face's own spring and from near pairs (physics.md A5).
  StepVote stable_step(Real dt_last) const;
  bool must_rearrange(Real dt) const;
  void rearrange();
  /// Forces at x(n+1) with v(n+1/2); books contact.spring and contact.damping.
  void add_forces(Real dt);
  void add_totals(Totals<Dim>& totals) const;
  std::vector<PairReport> reports() const;
  ContactView view() const;
  std::size_t n_facets() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace brunt
