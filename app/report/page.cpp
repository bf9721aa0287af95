#include "app/report/page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "app/report/curves.hpp"
#include "io/drawing.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {
constexpr const char* kStyle = R"(
body{font:15px/1.45 system-ui,sans-serif;color:#282828;max-width:1040px;margin:28px auto;
padding:0 18px}
h1{font-size:24px;margin:0 0 4px}h2{font-size:18px;margin:34px 0 8px}
table{border-collapse:collapse}
td,th{padding:3px 16px 3px 0;border-bottom:1px solid #e2e5e9;text-align:left}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}
.ended{color:#4a5058}.bad{color:#b01e32;font-weight:600}
img{max-width:49%;margin:0 4px 8px 0;border:1px solid #e2e5e9}
svg{max-width:100%;height:auto;display:block;margin:0 0 10px}
pre{background:#f5f6f8;padding:12px;overflow:auto;font-size:13px})";

std::string text_cell(const std::string& text) { return "<td>" + escaped_xml(text) + "</td>"; }
std::string number_cell(const std::string& text) {
  return "<td class=\"n\">" + escaped_xml(text) + "</td>";
}
std::string percent(Real share) { return rounded(100 * share, 3) + " %"; }

/// A table from the cells of its rows; names of columns that begin with '#' are of numbers.
std::string table(const std::vector<std::string>& names, const std::vector<std::string>& rows) {
  std::string out = "<table><tr>";
  for (const auto& name : names) {
    out += name.starts_with('#') ? "<th class=\"n\">" + escaped_xml(name.substr(1)) + "</th>"
                                 : "<th>" + escaped_xml(name) + "</th>";
  }
  out += "</tr>\n";
  for (const auto& row : rows) out += "<tr>" + row + "</tr>\n";
  return out + "</table>\n";
}

std::string heading(const RunReport& report) {
  const auto& summary = report.summary;
  const bool good = summary.status == kDone;
  std::string out = "<h1>" + escaped_xml(report.title) + "</h1>\n<p class=\"" +
                    (good ? "ended" : "bad") + "\">" + status_word(summary.status);
  if (!summary.reason.empty()) out += ": " + escaped_xml(summary.reason);
  if (!report.history.rows.empty()) {
    out += ", at " + rounded(report.history.rows.back().front(), 6) + " s";
  }
  out += ", " + std::to_string(summary.steps) + " steps; brunt " + escaped_xml(summary.version) +
         ", deck " + escaped_xml(summary.deck_hash) + "</p>\n";
  std::vector<std::string> rows;
  for (const auto& [name, text] : summary.parameters) {
    rows.push_back(text_cell(name) + text_cell(text));
  }
  for (const auto& text : summary.overrides) rows.push_back(text_cell("--set") + text_cell(text));
  if (!rows.empty()) out += table({"parameter", "value"}, rows);
  return out;
}

/// (value - target)/|target|; of a target of zero the value itself.
std::string error_text(Real value, const std::optional<Real>& target) {
  if (!target || !std::isfinite(value)) return "";
  return *target == 0 ? rounded(value, 4) : percent((value - *target) / std::fabs(*target));
}

std::string measures(const RunSummary& summary) {
  if (summary.measures.empty()) return "";
  const auto optional_text = [](const std::optional<Real>& value) {
    return value ? rounded(*value, 6) : std::string();
  };
  std::vector<std::string> rows;
  for (const auto& measure : summary.measures) {
    rows.push_back(text_cell(measure.name) + number_cell(rounded(measure.value, 6)) +
                   text_cell(measure.unit) + number_cell(optional_text(measure.bound)) +
                   number_cell(optional_text(measure.exact)) +
                   number_cell(error_text(measure.value, measure.exact)) +
                   number_cell(optional_text(measure.reference)) +
                   number_cell(error_text(measure.value, measure.reference)));
  }
  return "<h2>Measures</h2>\n" + table({"measure", "#value", "unit", "#+- by size", "#exact",
                                        "#error", "#reference", "#error"},
                                       rows);
}

std::string charts(const History& history) {
  if (history.rows.size() < 2) return "";
  std::vector<Real> time;
  for (const auto& row : history.rows) time.push_back(row.front());
  std::string out = "<h2>Over time</h2>\n";
  for (const auto& chart : charts_of(history)) out += to_svg(draw_chart(chart, time));
  return out;
}

std::string pictures(const RunReport& report) {
  if (report.pictures.empty()) return "";
  std::string out = "<h2>Pictures</h2>\n";
  for (const auto& [name, bytes] : report.pictures) {
    out += "<img alt=\"" + escaped_xml(name) + "\" title=\"" + escaped_xml(name) +
           "\" src=\"data:image/png;base64," + base64(bytes) + "\">\n";
  }
  return out;
}

std::string ledger(const RunReport& report) {
  const auto& [title, summary, history, deck, images] = report;
  if (history.rows.empty()) return "";
  std::vector<std::string> rows;
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    const std::string& name = history.columns[c];
    const Real value = history.rows.back()[c];
    if (!name.starts_with("energy.") || name == "energy.drift" || value == 0) continue;
    const Real share = summary.energy.largest > 0 ? value / summary.energy.largest : 0;
    rows.push_back(text_cell(name) + number_cell(rounded(value, 6)) + number_cell(percent(share)));
  }
  std::string out = "<h2>Energy at the end</h2>\n" +
                    table({"column", "#J", "#of the largest energy"}, rows) + "<p>Drift " +
                    rounded(summary.drift, 3) + "; energy that nobody put in, at most " +
                    percent(summary.energy.created) + " of the largest";
  for (const auto& [name, share] : summary.energy.sources) {
    out += ", " + escaped_xml(name) + " " + percent(share);
  }
  for (const auto& [body, share] : summary.energy.hourglass) {
    out += "; hourglass of " + escaped_xml(body) + " " + percent(share) + " of its stress work";
  }
  return out + ".</p>\n";
}

std::string warnings(const RunSummary& summary) {
  if (summary.warnings.empty()) return "";
  std::string out = "<h2>Warnings</h2>\n<ul>\n";
  for (const auto& warning : summary.warnings)
    out += "<li>" + escaped_xml(warning.text) + "</li>\n";
  return out + "</ul>\n";
}

std::string cost(const RunSummary& summary) {
  std::vector<std::string> rows;
  const auto add = [&](const std::string& name, const std::string& value) {
    rows.push_back(text_cell(name) + number_cell(value));
  };
  if (summary.elements > 0) add("elements", std::to_string(summary.elements));
  if (summary.particles > 0) add("particles", std::to_string(summary.particles));
  add("wall time [s]", rounded(summary.wall_seconds, 4));
  add("processor time [s]", rounded(summary.cpu_seconds, 4));
  add("ranks, threads each",
      std::to_string(summary.ranks) + ", " + std::to_string(summary.threads));
  add("peak memory [MB]", rounded(summary.peak_memory / 1e6, 4));
  for (const auto& [name, seconds] : summary.phases) {
    if (seconds > 0) add(name + " [s]", rounded(seconds, 3));
  }
  return "<h2>Cost</h2>\n" + table({"what", "#"}, rows);
}
}  // namespace

std::string base64(const std::string& bytes) {
  static constexpr const char* kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += i + k > bytes.size() ? '=' : kLetters[three >> (18 - 6 * k) & 63];
    }
  }
  return out;
}

std::string html_page(const RunReport& report) {
  std::string out = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
                    escaped_xml(report.title) + "</title><style>" + kStyle +
                    "</style></head><body>\n";
  out += heading(report) + measures(report.summary) + warnings(report.summary) +
         charts(report.history) + pictures(report) + ledger(report) + cost(report.summary);
  out += "<h2>Deck</h2>\n<details><summary>as it was resolved, in SI</summary><pre>" +
         escaped_xml(report.deck) + "</pre></details>\n";
  return out + "</body></html>\n";
}

}  // namespace brunt
