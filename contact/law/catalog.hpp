#pragma once
/// The laws of contact that a deck may choose from. A law is its own file, its name here, and its
/// test (docs/adding.md).
#include <tuple>
#include <type_traits>
#include <variant>

#include "contact/law/cohesive_bond.hpp"
#include "contact/law/contact_conductance.hpp"
#include "contact/law/contact_heat.hpp"

namespace brunt {

/// The deck's `heat` of a pair: whether heat passes from body to body where they touch. A law has
///   Real conductance(Real pressure) const;  // [W/m^2/K] under a pressure [Pa]; may be infinite
///   Real gap() const;                       // [m] opening up to which heat passes
using ContactHeat = std::variant<NoContactHeat, PerfectContactHeat, ContactConductance>;

inline Real conductance_of(const ContactHeat& heat, Real pressure) {
  return std::visit([&](const auto& law) { return law.conductance(pressure); }, heat);
}
inline Real gap_of(const ContactHeat& heat) {
  return std::visit([](const auto& law) { return law.gap(); }, heat);
}

/// What may hold faces together from time 0 on, each with keys among those of a pair. A law has
///   bool acts() const;                           // the deck asks for it
///   bool begins(Real gap, Real rounding) const;  // between faces `gap` [m] apart at time 0
///   bool tears(Real pull) const;                 // under a pull [Pa]
///   bool breaks_by_slip() const;
///   Real slip_limit(const ContactState& at, Real coefficient) const;  // [N] at which it slips
using Bonds = std::tuple<CohesiveBond>;

/// That of the bonds of a pair which acts, or none.
template <class Laws>
class ChosenBond;
template <class... Laws>
class ChosenBond<std::tuple<Laws...>> {
 public:
  ChosenBond() = default;
  /// laws  outlive it
  explicit ChosenBond(const std::tuple<Laws...>& laws) {
    std::apply([&](const auto&... law) { (choose(law), ...); }, laws);
  }
  bool any() const { return law_.index() != 0; }
  bool begins(Real gap, Real rounding) const {
    return ask(false, [&](const auto& law) { return law.begins(gap, rounding); });
  }
  bool tears(Real pull) const {
    return ask(true, [&](const auto& law) { return law.tears(pull); });
  }
  bool breaks_by_slip() const {
    return ask(false, [](const auto& law) { return law.breaks_by_slip(); });
  }
  Real slip_limit(const ContactState& at, Real coefficient) const {
    return ask(Real{0}, [&](const auto& law) { return law.slip_limit(at, coefficient); });
  }

 private:
  template <class Law>
  void choose(const Law& law) {
    if (!any() && law.acts()) law_ = &law;
  }
  template <class Answer, class Question>
  Answer ask(Answer of_none, const Question& question) const {
    return std::visit(
        [&](const auto& law) -> Answer {
          if constexpr (std::is_same_v<std::decay_t<decltype(law)>, std::monostate>) {
            return of_none;
          } else {
            return question(*law);
          }
        },
        law_);
  }
  std::variant<std::monostate, const Laws*...> law_;
};
using BondLaw = ChosenBond<Bonds>;

}  // namespace brunt
// Tested by tests/unit/contact/cohesive_bond_test.cpp.
