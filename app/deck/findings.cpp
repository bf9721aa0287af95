#include "app/deck/findings.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace brunt::deck {

bool related(const std::string& a, const std::string& b) {
  const auto below = [](const std::string& outer, const std::string& inner) {
    return inner == outer || inner.starts_with(outer + ".");
  };
  return below(a, b) || below(b, a);
}

Findings::Findings(const DeckPlaces& places, std::vector<DeckProblem>& problems,
                   std::vector<DeckProblem>& warnings)
    : places_(places), problems_(problems), warnings_(warnings) {
  for (const auto& problem : problems) {
    if (!problem.path.empty()) unread_.push_back(problem.path);
    section_unknown_ = section_unknown_ || problem.path.empty();
  }
}

void Findings::wrong(const std::string& path, const std::string& message) {
  problems_.push_back(places_.problem(path, message));
}

void Findings::warn(const std::string& path, const std::string& message) {
  warnings_.push_back(places_.problem(path, message));
}

bool Findings::stands(const std::string& path) const { return places_.has(path); }

int Findings::line(const std::string& path) const { return places_.place(path).line; }

bool Findings::warned(const std::string& path) const {
  return std::any_of(warnings_.begin(), warnings_.end(),
                     [&](const DeckProblem& warning) { return related(warning.path, path); });
}

void Findings::also_wrong(const std::string& path) { also_wrong_.push_back(path); }

bool Findings::sound(const std::string& path) const {
  // A section that is not known may be any that the deck lacks.
  if (section_unknown_ && !stands(path.substr(0, path.find('.')))) return false;
  return std::none_of(unread_.begin(), unread_.end(),
                      [&](const std::string& unread) { return related(unread, path); });
}

std::string short_text(Real value) {
  std::ostringstream out;
  out.precision(4);
  out << value;
  return out.str();
}

namespace {
/// A value with the largest prefix that leaves it at 1 or above.
std::string with_prefix(Real value, const char* unit) {
  struct Prefix {
    const char* text;
    Real factor;
  };
  static constexpr Prefix kPrefixes[] = {{"", 1}, {"m", 1e3}, {"u", 1e6}, {"n", 1e9}};
  constexpr Real kRoundOff = 1e-12;
  for (const auto& [text, factor] : kPrefixes) {
    if (value == 0 || std::fabs(value) * factor >= 1 - kRoundOff) {
      return short_text(value * factor) + " " + text + unit;
    }
  }
  return short_text(value) + " " + unit;
}
}  // namespace

std::string length_text(Real length) { return with_prefix(length, "m"); }
std::string time_text(Real time) { return with_prefix(time, "s"); }

}  // namespace brunt::deck
