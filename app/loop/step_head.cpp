#include "app/loop/step_head.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <set>
#include <string>

namespace brunt {

namespace {
/// A head as it travels: the reason by its text.
struct Letter {
  StepHead head;
  std::array<char, 32> reason;
};

/// A text that lives as long as the program.
const char* interned(const std::string& text) {
  static std::set<std::string> texts;
  return texts.insert(text).first->c_str();
}
}  // namespace

bool StepHead::take(const StepHead& other) {
  requests.checkpoint = requests.checkpoint || other.requests.checkpoint;
  requests.stop = requests.stop || other.requests.stop;
  heat_step = std::min(heat_step, other.heat_step);
  const bool number = step_limit.step == step_limit.step,
             other_number = other.step_limit.step == other.step_limit.step;
  if (!number || (other_number && !other.step_limit.before(step_limit))) return false;
  step_limit = other.step_limit;
  return true;
}

StepHead over_ranks(const StepHead& mine, const Communicator& ranks) {
  if (ranks.alone()) return mine;
  Letter letter{mine, {}};
  std::strncpy(letter.reason.data(), mine.step_limit.reason, letter.reason.size() - 1);
  letter = ranks.reduce(letter, [](Letter& a, const Letter& b) {
    if (a.head.take(b.head)) a.reason = b.reason;
  });
  letter.head.step_limit.reason =
      interned(letter.reason.data());  // the pointer is that of another rank
  return letter.head;
}

}  // namespace brunt
