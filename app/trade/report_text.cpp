/// The tables of a trade for the terminal.
#include <algorithm>
#include <cmath>

#include "app/trade/report.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {
using Lines = std::vector<std::vector<std::string>>;

/// Characters that a terminal shows.
std::size_t shown_width(const std::string& text) {
  return slot_of(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

/// First and last column to the left, others to the right.
std::string lined_up(const Lines& lines) {
  std::vector<std::size_t> width(lines.front().size(), 0);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c) {
      width[c] = std::max(width[c], shown_width(line[c]));
    }
  }
  std::string out;
  for (const auto& line : lines) {
    std::string text;
    for (std::size_t c = 0; c < line.size(); ++c) {
      const std::string room(width[c] - shown_width(line[c]), ' ');
      const bool left = c == 0 || c + 1 == line.size();
      text += (c > 0 ? "  " : "") + (left ? line[c] + room : room + line[c]);
    }
    out += text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

std::string share_text(Real share) {
  if (share == 0) return "-";
  return rounded(100 * share, 2) + " %";
}

std::string signed_share_text(Real share) {
  if (share == 0) return "-";
  return (share > 0 ? "+" : "") + rounded(100 * share, 2) + " %";
}

std::string seconds_text(const VariantRuns& runs) {
  const Repeated& time = runs.processor;
  std::string text = rounded(time.median, 3);
  if (time.count > 1) text += " (" + rounded(time.low, 3) + ".." + rounded(time.high, 3) + ")";
  return runs.whole_cost ? text : "~" + text;
}

std::string costs_text(const Trade& trade) {
  Lines lines{{"", "steps", "points", "steps x points", "processor time [s]", "memory [MB]",
               "created", "hourglass", "artificial stress", "contact.pairs", ""}};
  for (const auto& row : trade.rows) {
    const auto& summary = row.runs.summary;
    if (!row.runs.done) {
      lines.push_back({row.label, "-", "-", "-", "-", "-", "-", "-", "-", "-", row.runs.problem});
      continue;
    }
    std::string note = row.runs.same ? "" : "REPEATS DIFFER";
    if (!row.runs.whole_cost) note += "went on after an interruption: time scaled";
    lines.push_back({row.label, std::to_string(summary.steps), std::to_string(summary.points),
                     rounded(row.work, 3), seconds_text(row.runs),
                     rounded(row.runs.memory.median / 1e6, 3), share_text(row.created),
                     share_text(row.hourglass), signed_share_text(row.artificial_stress),
                     signed_share_text(row.contact_pairs), note});
  }
  return lined_up(lines);
}

std::string mark_text(const Trade& trade, const TradeFront& front, std::size_t row) {
  if (!front.errors[row]) return "";
  if (front.against == Against::finest && trade.finest == row) return "the finest";
  const auto by = front.dominated_by[row];
  if (!by) return "front";
  const std::string text = "dominated by " + trade.rows[*by].label;
  return front.clear[row] ? text : text + " (within the spread of times)";
}

std::string measure_text(const Trade& trade, std::size_t m) {
  const TradeFront& front = trade.fronts[m];
  const std::string& unit = trade.units[m];
  const auto cell = [&](const std::optional<SignedError>& error) {
    return error ? error_text(*error, unit) : std::string("-");
  };
  const std::string title = unit.empty() || unit == "any" || unit == "1"
                                ? trade.measures[m]
                                : trade.measures[m] + " [" + unit + "]";
  Lines lines{{title, "value", "to exact", "to finest", "to reference",
               std::string("front by ") + against_word(front.against)}};
  for (std::size_t r = 0; r < trade.rows.size(); ++r) {
    const auto& errors = trade.rows[r].measures[m];
    if (!errors.value) continue;
    lines.push_back({trade.rows[r].label, rounded(*errors.value, 6), cell(errors.exact),
                     cell(errors.finest), cell(errors.reference), mark_text(trade, front, r)});
  }
  std::string text = lined_up(lines);
  for (const auto& fit : trade.fits) {
    if (fit.measure != m) continue;
    const Real finest = *trade.rows[fit.finest].measures[m].value;
    text += "  over " + fit.along + ", of " + std::to_string(fit.rows.size()) + " runs down to " +
            trade.rows[fit.finest].label + ": " + convergence_text(fit.convergence, finest, unit) +
            "\n";
  }
  return text;
}

std::string all_text(const Trade& trade) {
  const TradeFront& front = trade.fronts.back();
  Lines lines{{"all measures", "largest error", std::string("front")}};
  for (std::size_t r = 0; r < trade.rows.size(); ++r) {
    if (!front.errors[r]) continue;
    lines.push_back(
        {trade.rows[r].label, error_text(*front.errors[r], ""), mark_text(trade, front, r)});
  }
  return lined_up(lines);
}
}  // namespace

std::string error_text(const SignedError& error, const std::string& unit) {
  const bool plain = unit.empty() || unit == "any" || unit == "1";
  std::string text = error.error > 0 ? "+" : "";
  if (error.relative) return text + rounded(100 * error.error, 3) + " %";
  return text + rounded(error.error, 3) + (plain ? "" : " " + unit);
}

std::string convergence_text(const Convergence& convergence, Real finest, const std::string& unit) {
  const std::string of_unit = unit.empty() || unit == "any" || unit == "1" ? "" : " " + unit;
  std::string text = convergence.words;
  if (convergence.limit && convergence.order) {
    text += ", Richardson's estimate " + rounded(*convergence.limit, 6) + of_unit;
  }
  text += "; within " + rounded(convergence.bound, 3) + of_unit;
  if (finest != 0) {
    text += " (" + rounded(100 * std::fabs(convergence.bound / finest), 2) + " %)";
  }
  return text;
}

std::string trade_text(const Trade& trade) {
  std::string text = costs_text(trade);
  if (!trade.finest) return text;
  text += "finest: " + trade.rows[*trade.finest].label + "\n";
  for (std::size_t m = 0; m < trade.measures.size(); ++m) text += "\n" + measure_text(trade, m);
  if (trade.measures.size() > 1) text += "\n" + all_text(trade);
  return text;
}

}  // namespace brunt
// Tested by tests/unit/app/trade_results_test.cpp.
