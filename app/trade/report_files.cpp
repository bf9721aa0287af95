/// The files of a trade for programs: every digit of each number.
#include <array>
#include <cmath>
#include <cstdio>

#include "app/trade/report.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {
std::string json_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 32) {
      std::array<char, 8> code{};
      std::snprintf(code.data(), code.size(), "\\u%04x", c);
      out += code.data();
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string json_number(Real value) { return std::isfinite(value) ? shortest(value) : "null"; }
std::string json_number(const std::optional<Real>& value) {
  return value ? json_number(*value) : "null";
}
std::string json_flag(bool value) { return value ? "true" : "false"; }

std::string json_error(const std::optional<SignedError>& error) {
  if (!error) return "null";
  return R"({"error": )" + json_number(error->error) + R"(, "relative": )" +
         json_flag(error->relative) + "}";
}

std::string json_repeated(const Repeated& value) {
  return R"({"median": )" + json_number(value.median) + R"(, "low": )" + json_number(value.low) +
         R"(, "high": )" + json_number(value.high) + R"(, "runs": )" + std::to_string(value.count) +
         "}";
}

/// Items between brackets, one a line.
std::string json_list(const std::vector<std::string>& items, const char* indent) {
  std::string out = "[";
  for (std::size_t k = 0; k < items.size(); ++k) {
    out += (k > 0 ? ",\n" : "\n") + std::string(indent) + "  " + items[k];
  }
  return out + (items.empty() ? "]" : "\n" + std::string(indent) + "]");
}

std::string json_row(const Trade& trade, const TradeRow& row) {
  const auto& summary = row.runs.summary;
  std::string out = R"({"label": )" + json_text(row.label) + R"(, "folder": )" +
                    json_text(row.folder) + R"(, "overrides": [)";
  for (std::size_t k = 0; k < row.overrides.size(); ++k) {
    out += (k > 0 ? ", " : "") + json_text(row.overrides[k]);
  }
  out += R"(], "done": )" + json_flag(row.runs.done) + R"(, "problem": )" +
         json_text(row.runs.problem);
  if (!row.runs.done) return out + "}";
  out += R"(, "same_answer": )" + json_flag(row.runs.same) + R"(, "deck_hash": )" +
         json_text(summary.deck_hash) + R"(, "steps": )" + std::to_string(summary.steps) +
         R"(, "points": )" + std::to_string(summary.points) + R"(, "elements": )" +
         std::to_string(summary.elements) + R"(, "particles": )" +
         std::to_string(summary.particles) + R"(, "processor_seconds": )" +
         json_repeated(row.runs.processor) + R"(, "whole_cost": )" +
         json_flag(row.runs.whole_cost) + R"(, "memory": )" + json_repeated(row.runs.memory) +
         R"(, "created": )" + json_number(row.created) + R"(, "hourglass": )" +
         json_number(row.hourglass) + R"(, "artificial_stress": )" +
         json_number(row.artificial_stress) + R"(, "contact_pairs": )" +
         json_number(row.contact_pairs) + R"(, "measures": {)";
  for (std::size_t m = 0; m < trade.measures.size(); ++m) {
    const auto& errors = row.measures[m];
    out += (m > 0 ? ", " : "") + json_text(trade.measures[m]) + R"(: {"value": )" +
           json_number(errors.value) + R"(, "exact": )" + json_error(errors.exact) +
           R"(, "finest": )" + json_error(errors.finest) + R"(, "reference": )" +
           json_error(errors.reference) + "}";
  }
  return out + "}}";
}

std::string json_front(const Trade& trade, const TradeFront& front) {
  std::string out = R"({"measure": )" + json_text(front.measure) + R"(, "unit": )" +
                    json_text(front.unit) + R"(, "against": )" +
                    json_text(against_word(front.against)) + R"(, "rows": [)";
  for (std::size_t r = 0; r < trade.rows.size(); ++r) {
    const auto by = front.dominated_by.empty() ? std::nullopt : front.dominated_by[r];
    out += (r > 0 ? ", " : "") + std::string(R"({"error": )") + json_error(front.errors[r]) +
           R"(, "dominated_by": )" + (by ? json_text(trade.rows[*by].label) : "null") +
           R"(, "clear": )" + json_flag(front.clear.empty() || front.clear[r]) + "}";
  }
  return out + "]}";
}

std::string json_fit(const Trade& trade, const TradeFit& fit) {
  std::string out =
      R"({"measure": )" + json_text(trade.measures[fit.measure]) + R"(, "along": )" +
      json_text(fit.along) + R"(, "finest": )" + json_text(trade.rows[fit.finest].label) +
      R"(, "asymptotic": )" + json_flag(fit.convergence.asymptotic) + R"(, "order": )" +
      json_number(fit.convergence.order) + R"(, "limit": )" + json_number(fit.convergence.limit) +
      R"(, "bound": )" + json_number(fit.convergence.bound) + R"(, "words": )" +
      json_text(fit.convergence.words) + R"(, "rows": [)";
  for (std::size_t k = 0; k < fit.rows.size(); ++k) {
    out += (k > 0 ? ", " : "") + json_text(trade.rows[fit.rows[k]].label);
  }
  return out + "]}";
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string csv_error(const std::optional<SignedError>& error) {
  return error ? shortest(error->error) : "";
}
}  // namespace

std::string trade_csv(const Trade& trade) {
  std::string out =
      "variant,measure,unit,value,exact_error,finest_error,reference_error,absolute,front,"
      "dominated_by,steps,points,processor_seconds,processor_low,processor_high,memory,created,"
      "hourglass,artificial_stress,contact_pairs\n";
  for (std::size_t r = 0; r < trade.rows.size(); ++r) {
    const TradeRow& row = trade.rows[r];
    for (std::size_t m = 0; m < row.measures.size(); ++m) {
      const auto& errors = row.measures[m];
      const auto& front = trade.fronts[m];
      if (!errors.value) continue;
      const auto by = front.dominated_by[r];
      const bool absolute = front.errors[r] && !front.errors[r]->relative;
      out += csv_text(row.label) + "," + csv_text(trade.measures[m]) + "," + trade.units[m] + "," +
             shortest(*errors.value) + "," + csv_error(errors.exact) + "," +
             csv_error(errors.finest) + "," + csv_error(errors.reference) + "," +
             (absolute ? "1" : "0") + "," + (front.errors[r] && !by ? "1" : "0") + "," +
             (by ? csv_text(trade.rows[*by].label) : "") + "," +
             std::to_string(row.runs.summary.steps) + "," + std::to_string(row.runs.summary.points);
      for (const Real number : {row.runs.processor.median, row.runs.processor.low,
                                row.runs.processor.high, row.runs.memory.median, row.created,
                                row.hourglass, row.artificial_stress, row.contact_pairs}) {
        out += "," + shortest(number);
      }
      out += "\n";
    }
  }
  return out;
}

std::string trade_json(const Trade& trade) {
  std::vector<std::string> rows, fronts, fits;
  for (const auto& row : trade.rows) rows.push_back(json_row(trade, row));
  for (const auto& front : trade.fronts) fronts.push_back(json_front(trade, front));
  for (const auto& fit : trade.fits) fits.push_back(json_fit(trade, fit));
  return "{\n  \"title\": " + json_text(trade.title) + ",\n  \"finest\": " +
         (trade.finest ? json_text(trade.rows[*trade.finest].label) : "null") +
         ",\n  \"variants\": " + json_list(rows, "  ") +
         ",\n  \"fronts\": " + json_list(fronts, "  ") + ",\n  \"fits\": " + json_list(fits, "  ") +
         "\n}\n";
}

}  // namespace brunt
// Tested by tests/unit/app/trade_results_test.cpp.
