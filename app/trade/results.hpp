#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/trade/convergence.hpp"
#include "app/trade/front.hpp"
#include "app/trade/study.hpp"

namespace brunt {

/// What errors are measured against.
enum class Against { exact, finest, reference };
const char* against_word(Against against);

/// A signed error: relative to the size of what it is measured against, absolute where that is 0.
struct SignedError {
  Real error = 0;
  bool relative = true;
};
SignedError signed_error(Real value, Real target);

/// One measure of one variant.
struct MeasureErrors {
  std::optional<Real> value;
  std::optional<SignedError> exact, finest, reference;
  const std::optional<SignedError>& against(Against which) const;
};

/// One variant of a trade.
struct TradeRow {
  std::string label, folder;
  std::vector<std::string> overrides;  ///< of the variant and the call
  VariantRuns runs;
  Real work = 0;               ///< steps x points
  Real created = 0;            ///< largest energy that nobody put in, over the largest energy
  Real hourglass = 0;          ///< largest of a body, over the work of its stresses
  Real artificial_stress = 0;  ///< taken (+) or given (-), over the largest energy
  Real contact_pairs = 0;      ///< the same
  std::vector<MeasureErrors> measures;
};

/// Costs and errors of one measure, or of all together, and who dominates whom.
struct TradeFront {
  std::string measure;  ///< "all": the largest relative error of all
  std::string unit;     ///< SI
  Against against = Against::exact;
  std::vector<std::optional<SignedError>> errors;        ///< of each row
  std::vector<std::optional<std::size_t>> dominated_by;  ///< of each row
  std::vector<bool> clear;  ///< of each row: beyond the spread of costs
};

/// The convergence of a measure over a size.
struct TradeFit {
  std::size_t measure = 0;
  std::string along;  ///< label of the key
  std::vector<std::size_t> rows;
  std::size_t finest = 0;  ///< row of which the bound holds
  Convergence convergence;
};

struct Trade {
  std::string title;
  int repeat = 1;
  std::vector<std::string> measures, units;
  std::vector<TradeRow> rows;
  std::optional<std::size_t> finest;  ///< the row of the most points, of them the most steps
  std::vector<TradeFront> fronts;     ///< of each measure, and of all where there are several
  std::vector<TradeFit> fits;
};

/// against  nothing: of each measure exact where the deck has it, else finest
Trade evaluate_trade(const std::vector<Variant>& variants, const std::vector<Vary>& varies,
                     const StudyResult& study, std::optional<Against> against);

/// Of the convergence of a measure over a series of runs; nothing with less than two values.
std::optional<Convergence> convergence_of(const std::vector<Real>& nominal,
                                          const std::vector<const RunSummary*>& runs,
                                          const std::string& measure);

}  // namespace brunt
