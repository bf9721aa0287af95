#pragma once
#include <tuple>
#include <type_traits>
#include <variant>

#include "contact/law/contact_state.hpp"

namespace brunt {

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

}  // namespace brunt
// Tested by tests/unit/contact/cohesive_bond_test.cpp.
