#include "app/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace brunt {

namespace {
double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}
}  // namespace

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
  const double fraction = clock.end() > 0 ? clock.time() / clock.end() : 1.0;
  const double elapsed = seconds_since(start_);
  const double left = fraction > 0 ? elapsed * (1 - fraction) / fraction : 0.0;
  constexpr int width = 24;
  std::string bar(width, ' ');
  for (int i = 0; i < width && i < fraction * width; ++i) bar[static_cast<std::size_t>(i)] = '#';
  std::fprintf(stderr,
               "%s[%s] %5.1f %%  t %.4g s  step %lld  dt %.3g s (%s)  drift %.1e  %.0f s left%s",
               terminal_ ? "\r" : "", bar.c_str(), 100 * fraction, clock.time(),
               static_cast<long long>(clock.step()), clock.dt(), whose.c_str(), drift, left,
               terminal_ ? "\033[K" : "\n");
  std::fflush(stderr);
  shown_ = true;
}

void Progress::finish() {
  if (shown_ && terminal_) std::fputs("\r\033[K", stderr);
  shown_ = false;
}

}  // namespace brunt
