#include "app/trade/results.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
constexpr Real kSameSize = 1e-6;  // closer sizes come to the same mesh

const MeasureResult* measure_of(const RunSummary& summary, const std::string& name) {
  for (const auto& measure : summary.measures) {
    if (measure.name == name) return &measure;
  }
  return nullptr;
}

Real share_named(const std::vector<std::pair<std::string, Real>>& shares, const char* name) {
  Real sum = 0;
  const std::string of_body = std::string(".") + name;
  for (const auto& [key, share] : shares) {
    if (key == name || key.ends_with(of_body)) sum += share;
  }
  return sum;
}

TradeRow row_of(const Variant& variant, const VariantRuns& runs) {
  TradeRow row;
  row.label = variant.label;
  row.folder = variant.folder;
  row.overrides = variant.overrides;
  row.runs = runs;
  const EnergyShares& energy = runs.summary.energy;
  row.work = static_cast<Real>(runs.summary.steps) * static_cast<Real>(runs.summary.points);
  row.created = energy.created;
  for (const auto& [body, share] : energy.hourglass) row.hourglass = std::max(row.hourglass, share);
  const auto balance = [&](const char* name) {
    return share_named(energy.taken, name) - share_named(energy.sources, name);
  };
  row.artificial_stress = balance("artificial_stress");
  row.contact_pairs = balance("contact.pairs");
  return row;
}

std::optional<std::size_t> finest_of(const std::vector<TradeRow>& rows) {
  std::optional<std::size_t> finest;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!rows[r].runs.done) continue;
    const auto rank = [&](std::size_t row) {
      return std::pair(rows[row].runs.summary.points, rows[row].runs.summary.steps);
    };
    if (!finest || rank(r) > rank(*finest)) finest = r;
  }
  return finest;
}

void add_errors(Trade& trade) {
  for (auto& row : trade.rows) {
    for (const auto& name : trade.measures) {
      MeasureErrors errors;
      const auto* measure = row.runs.done ? measure_of(row.runs.summary, name) : nullptr;
      if (measure != nullptr) {
        const Real value = measure->value;
        errors.value = value;
        if (measure->exact) errors.exact = signed_error(value, *measure->exact);
        if (measure->reference) errors.reference = signed_error(value, *measure->reference);
        const auto* finest = measure_of(trade.rows[*trade.finest].runs.summary, name);
        if (finest != nullptr) errors.finest = signed_error(value, finest->value);
      }
      row.measures.push_back(errors);
    }
  }
}

/// Who dominates whom, of the rows that have an error. The finest has none against itself.
void mark_front(const Trade& trade, TradeFront& front) {
  std::vector<std::size_t> rows;
  std::vector<CostError> points;
  for (std::size_t r = 0; r < trade.rows.size(); ++r) {
    const auto& error = front.errors[r];
    if (!error || !std::isfinite(error->error)) continue;
    if (front.against == Against::finest && trade.finest == r) continue;
    rows.push_back(r);
    points.push_back({trade.rows[r].runs.processor, std::fabs(error->error)});
  }
  front.dominated_by.resize(trade.rows.size());
  front.clear.resize(trade.rows.size(), true);
  const auto found = dominated(points);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (found[k].by) front.dominated_by[rows[k]] = rows[*found[k].by];
    front.clear[rows[k]] = found[k].clear;
  }
}

/// The exact value where some run has one, else the finest run.
Against choose_against(const Trade& trade, std::size_t m) {
  const bool any = std::any_of(trade.rows.begin(), trade.rows.end(), [m](const TradeRow& row) {
    return row.measures[m].exact.has_value();
  });
  return any ? Against::exact : Against::finest;
}

void add_fronts(Trade& trade, std::optional<Against> against) {
  TradeFront all{"all", "", against.value_or(Against::exact), {}, {}, {}};
  all.errors.resize(trade.rows.size());
  for (std::size_t m = 0; m < trade.measures.size(); ++m) {
    TradeFront front{trade.measures[m], trade.units[m], Against::exact, {}, {}, {}};
    front.against = against.value_or(choose_against(trade, m));
    if (front.against != Against::exact && !against) all.against = front.against;
    for (std::size_t r = 0; r < trade.rows.size(); ++r) {
      const auto& error = trade.rows[r].measures[m].against(front.against);
      front.errors.push_back(error);
      if (!error || !error->relative) continue;
      auto& worst = all.errors[r];
      if (!worst || std::fabs(error->error) > std::fabs(worst->error)) worst = error;
    }
    mark_front(trade, front);
    trade.fronts.push_back(std::move(front));
  }
  if (trade.measures.size() < 2) return;
  mark_front(trade, all);
  trade.fronts.push_back(std::move(all));
}

void add_fits(const std::vector<Variant>& variants, const std::vector<Vary>& varies, Trade& trade) {
  for (const auto& series : size_series(variants, varies.size())) {
    TradeFit fit;
    std::vector<Real> sizes;
    std::vector<const RunSummary*> runs;
    fit.along = varies[series.vary].label;
    for (std::size_t k = 0; k < series.variants.size(); ++k) {
      const auto& row = trade.rows[series.variants[k]];
      if (!row.runs.done) continue;
      fit.rows.push_back(series.variants[k]);
      sizes.push_back(series.sizes[k]);
      runs.push_back(&row.runs.summary);
    }
    if (sizes.size() < 2) continue;
    const auto least = std::min_element(sizes.begin(), sizes.end()) - sizes.begin();
    fit.finest = fit.rows[slot_of(least)];
    for (fit.measure = 0; fit.measure < trade.measures.size(); ++fit.measure) {
      const auto found = convergence_of(sizes, runs, trade.measures[fit.measure]);
      if (!found) continue;
      fit.convergence = *found;
      trade.fits.push_back(fit);
    }
  }
}
}  // namespace

const char* against_word(Against against) {
  switch (against) {
    case Against::exact:
      return "exact";
    case Against::finest:
      return "finest";
    default:
      return "reference";
  }
}

SignedError signed_error(Real value, Real target) {
  if (target == 0) return {value, false};
  return {(value - target) / std::fabs(target), true};
}

const std::optional<SignedError>& MeasureErrors::against(Against which) const {
  if (which == Against::exact) return exact;
  return which == Against::finest ? finest : reference;
}

std::optional<Convergence> convergence_of(const std::vector<Real>& nominal,
                                          const std::vector<const RunSummary*>& runs,
                                          const std::string& measure) {
  std::vector<Real> sizes, cells;
  std::vector<SizedValue> values;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto* found = measure_of(*runs[k], measure);
    if (found == nullptr || !std::isfinite(found->value)) continue;
    sizes.push_back(nominal[k]);
    cells.push_back(static_cast<Real>(runs[k]->elements + runs[k]->particles));
    values.push_back({0, found->value});
  }
  if (values.size() < 2) return std::nullopt;
  const auto effective = effective_sizes(sizes, cells);
  for (std::size_t k = 0; k < values.size(); ++k) values[k].size = effective[k];
  std::sort(values.begin(), values.end(),
            [](const auto& a, const auto& b) { return a.size < b.size; });
  // Two sizes that come to the same mesh count once.
  const auto last = std::unique(values.begin(), values.end(), [](const auto& a, const auto& b) {
    return b.size - a.size < kSameSize * b.size;
  });
  values.erase(last, values.end());
  if (values.size() < 2) return std::nullopt;
  return fit_convergence(values);
}

Trade evaluate_trade(const std::vector<Variant>& variants, const std::vector<Vary>& varies,
                     const StudyResult& study, std::optional<Against> against) {
  Trade trade;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    trade.rows.push_back(row_of(variants[v], study.runs[v]));
    trade.repeat = std::max(trade.repeat, study.runs[v].memory.count);
  }
  trade.finest = finest_of(trade.rows);
  if (!trade.finest) return trade;
  trade.title = variants[*trade.finest].loaded.deck.title;
  for (const auto& measure : trade.rows[*trade.finest].runs.summary.measures) {
    trade.measures.push_back(measure.name);
    trade.units.push_back(measure.unit);
  }
  add_errors(trade);
  add_fronts(trade, against);
  add_fits(variants, varies, trade);
  return trade;
}

}  // namespace brunt
// Tested by tests/unit/app/trade_results_test.cpp.
