#pragma once
#include <tuple>
#include <variant>

#include "core/types.hpp"

namespace brunt {

template <class... Laws>
int count_acting(const std::tuple<Laws...>& laws) {
  return std::apply([](const auto&... law) { return (int{law.acts()} + ... + 0); }, laws);
}

/// The law of closure of a joint, or a line where none acts.
template <class Laws>
class ChosenClosure;
template <class... Laws>
class ChosenClosure<std::tuple<Laws...>> {
  struct Line {
    Real most() const { return kInfinity; }
    Real pressure(Real k, Real u) const { return k * u; }
    Real slope(Real k, Real) const { return k; }
    Real closure_at(Real, Real) const { return kInfinity; }
    Real work(Real k, Real u) const { return 0.5 * k * u * u; }
    Real lost(Real, Real) const { return 0; }
  };

 public:
  constexpr ChosenClosure() = default;
  explicit ChosenClosure(const std::tuple<Laws...>& laws) {
    std::apply([&](const auto&... law) { ((law.acts() ? void(law_ = law) : void()), ...); }, laws);
  }
  template <class Law>
  static ChosenClosure of(const Law& law) {
    ChosenClosure chosen;
    chosen.law_ = law;
    return chosen;
  }
  bool any() const { return law_.index() != 0; }
  Real most() const {
    return std::visit([](const auto& law) { return law.most(); }, law_);
  }
  Real pressure(Real k, Real u) const {
    return std::visit([&](const auto& law) { return law.pressure(k, u); }, law_);
  }
  Real slope(Real k, Real u) const {
    return std::visit([&](const auto& law) { return law.slope(k, u); }, law_);
  }
  Real closure_at(Real k, Real slope) const {
    return std::visit([&](const auto& law) { return law.closure_at(k, slope); }, law_);
  }
  Real work(Real k, Real u) const {
    return std::visit([&](const auto& law) { return law.work(k, u); }, law_);
  }
  Real lost(Real k, Real u) const {
    return std::visit([&](const auto& law) { return law.lost(k, u); }, law_);
  }

 private:
  std::variant<Line, Laws...> law_;
};

}  // namespace brunt
// Tested by tests/unit/contact/joint_test.cpp.
