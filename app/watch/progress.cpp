#include "app/watch/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/deck/findings.hpp"

namespace brunt {

namespace {
double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Columns of the terminal; a longer line would leave its rest behind.
std::size_t terminal_width() {
  winsize size{};
  constexpr std::size_t kUsual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsual;
}

std::string bar_of(double fraction, int width) {
  const int full = std::clamp(static_cast<int>(fraction * width), 0, width);
  return "[" + std::string(slot_of(full), '#') + std::string(slot_of(width - full), '.') + "] ";
}
}  // namespace

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(std::max(0.0, seconds)));
  char text[64];
  if (whole < 60) {
    std::snprintf(text, sizeof text, "%lld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof text, "%lld min %02lld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%lld h %02lld min", whole / 3600, whole % 3600 / 60);
  }
  return text;
}

std::string progress_text(const ProgressState& state) {
  const double fraction = state.end > 0 ? state.time / state.end : 1.0;
  char head[64], tail[64];
  std::snprintf(head, sizeof head, "%5.1f %%  ", 100 * fraction);
  std::snprintf(tail, sizeof tail, "  drift %.0e", std::fabs(state.drift));
  std::string text = head + deck::time_text(state.time) + " of " + deck::time_text(state.end) +
                     "  step " + std::to_string(state.step) + "  dt " + deck::time_text(state.dt) +
                     " (" + state.whose + ")" + tail;
  // A rate of the first instants says nothing.
  constexpr double kEnough = 1e-3;
  if (fraction > kEnough) {
    text += "  " + duration_text(state.elapsed * (1 - fraction) / fraction) + " left";
  }
  return text;
}

Progress::Progress(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

void Progress::show(const Clock& clock, const std::string& whose, Real drift) {
  if (quiet_) return;
  const double interval = terminal_ ? 0.2 : 10.0;
  if (seconds_since(last_) < interval) return;
  last_ = std::chrono::steady_clock::now();
  std::string line = progress_text({clock.real_time(), clock.real(clock.end()), clock.step(),
                                    clock.real(clock.dt()), whose, drift, seconds_since(start_)});
  shown_ = true;
  if (!terminal_) {
    std::fprintf(stderr, "%s\n", line.c_str());
    return;
  }
  constexpr int kBar = 20;
  const std::size_t width = terminal_width();
  if (line.size() + kBar + 4 <= width) line = bar_of(clock.time() / clock.end(), kBar) + line;
  std::fprintf(stderr, "\r%s\033[K", line.substr(0, width - 1).c_str());
  std::fflush(stderr);
}

void Progress::finish() {
  if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace brunt
