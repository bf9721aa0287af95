#include "io/deck/suggest.hpp"

#include <algorithm>
#include <vector>

namespace brunt {

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

namespace {
/// True where they differ in capital letters alone.
bool same_letters(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return small(x) == small(y); });
}
}  // namespace

std::string nearest_word(std::string_view word, std::span<const std::string> known) {
  constexpr std::size_t kLongest = 64;
  if (word.size() > kLongest) return "";
  // One of many: "body" or "bodys" for "bodies" is further away than a typing error.
  const std::string_view one = word.ends_with("ys") ? word.substr(0, word.size() - 1) : word;
  if (one.ends_with('y')) {
    std::string plural = std::string(one.substr(0, one.size() - 1)) + "ies";
    if (std::find(known.begin(), known.end(), plural) != known.end()) return plural;
  }
  // "Us" is no typing error for "ms".
  const auto letters = std::find_if(known.begin(), known.end(),
                                    [&](const auto& one) { return same_letters(one, word); });
  if (letters != known.end()) return *letters;
  std::string nearest;
  int least = std::max(1, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string& candidate : known) {
    const int distance = edit_distance(word, candidate);
    if (distance < least && distance < static_cast<int>(candidate.size())) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string suggestion(std::string_view word, std::span<const std::string> known) {
  const std::string nearest = nearest_word(word, known);
  if (!nearest.empty()) return "; did you mean '" + nearest + "'?";
  constexpr std::size_t kMany = 40;
  if (known.empty() || known.size() > kMany) return "";
  std::string list;
  for (const std::string& candidate : known) list += (list.empty() ? "" : ", ") + candidate;
  return "; known are " + list;
}

}  // namespace brunt
