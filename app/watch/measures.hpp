#pragma once
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "core/view.hpp"

namespace brunt {

/// The value of one measure of the deck.
struct MeasureValue {
  std::string name;
  Real value = 0;  ///< SI
  std::string unit;
  std::optional<Real> reference;
};

/// What measures read: views of bodies at the moment and at time 0, and the history so far.
struct MeasureSource {
  std::function<BodyView(const std::string& body)> view;
  const std::map<std::string, BodyView>* start = nullptr;  ///< by body, at time 0
  const std::vector<std::string>* columns = nullptr;       ///< names of history columns
  const std::vector<std::vector<Real>>* rows = nullptr;    ///< history so far
};

/// Evaluates one measure; an expression reads the values found before it.
/// Throws DeckError-free std::invalid_argument where body, field or column do not exist.
Real evaluate_measure(const deck::Measure& measure, const MeasureSource& source,
                      const std::vector<MeasureValue>& before);

}  // namespace brunt
