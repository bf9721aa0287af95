#include "app/watch/lost_contacts.hpp"

#include "app/deck/findings.hpp"
#include "contact/contacts/deep.hpp"

namespace brunt {

namespace {
std::string place_text(const LostReport& lost, int dim) {
  std::string text = "t = " + deck::time_text(lost.time) + ", at (";
  for (int c = 0; c < dim; ++c) {
    text += (c == 0 ? "" : ", ") + deck::short_text(lost.point[c]);
  }
  return text + ") m";
}
}  // namespace

std::string lost_text(const LostPair& pair, int dim) {
  const auto& lost = pair.lost;
  const std::string where = place_text(lost, dim), depth = deck::length_text(lost.depth);
  const std::string remedy =
      " try finer elements, a higher contact `stiffness`, a smaller `time.safety`, or a "
      "`strength` where elements have none";
  if (lost.key.kind == ContactKind::particle_face) {
    return "a particle came " + depth + " behind a face and is given up since " + where +
           ": it goes through; try a higher contact `stiffness`, a smaller `time.safety`, or "
           "particles and elements of more equal size";
  }
  if (lost.key.ordinal == kLetGo) {
    return "faces came " + depth + " into each other and let go at " + where +
           ": the bodies go through each other there;" + remedy;
  }
  if (lost.key.ordinal == kDeep) {
    return "faces came " + depth + " into each other at " + where +
           ", more than three quarters of what contacts hold: they hold yet, but bodies overlap by "
           "most of an element there;" +
           remedy;
  }
  if (lost.key.ordinal == kCrossed) {
    return "faces came " + depth + " through each other at " + where +
           ": an edge or corner of one body is inside the other, where no faces oppose each other "
           "and nothing pushes it out; try blunter edges, finer elements, or a higher contact "
           "`stiffness`";
  }
  return "faces that had gone through each other came back to " + depth + " at " + where +
         ": elements have folded, or let go before, and feel each other again once they have "
         "opened;" +
         remedy;
}

std::string lost_count_text(const LostPair& pair) {
  const auto& lost = pair.lost;
  if (!lost.any()) return "all contacts held";
  return "in all " + std::to_string(lost.let_go) + " contacts let go, " +
         std::to_string(lost.from_behind) + " came back, and " + std::to_string(lost.crossed) +
         " faces went through each other without a push";
}

std::vector<std::string> LostContactWarnings::take(const std::vector<LostPair>& pairs) {
  std::vector<std::string> texts;
  for (const auto& pair : pairs) {
    const auto before = warned_.find(pair.name);
    const bool first = before == warned_.end() || (pair.lost.any() && !before->second.lost.any());
    warned_[pair.name] = pair;
    if (first) texts.push_back(pair.name + ": " + lost_text(pair, dim_));
  }
  return texts;
}

std::map<std::string, std::string> LostContactWarnings::all() const {
  std::map<std::string, std::string> texts;
  for (const auto& [name, pair] : warned_) {
    texts[name] = name + ": " + lost_text(pair, dim_) + "; " + lost_count_text(pair);
  }
  return texts;
}

}  // namespace brunt
