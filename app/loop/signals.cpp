#include "app/loop/signals.hpp"

#include <csignal>
#include <initializer_list>

namespace brunt {

namespace {
// A handler may only set a flag; the run reads it between steps.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): a handler has no other way.
volatile std::sig_atomic_t checkpoint_requested = 0;
volatile std::sig_atomic_t stop_requested = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

void on_signal(int signal) {
  if (signal == SIGUSR1) {
    checkpoint_requested = 1;
  } else {
    stop_requested = 1;
    if (signal != SIGUSR2) std::signal(signal, SIG_DFL);  // a second one ends the run at once
  }
}
}  // namespace

void listen_to_signals() {
  for (const int signal : {SIGUSR1, SIGUSR2, SIGTERM, SIGINT, SIGHUP}) {
    struct sigaction action {};
    // Who started the run with nohup wants it to outlive the terminal.
    if (signal == SIGHUP && sigaction(signal, nullptr, &action) == 0 &&
        action.sa_handler == SIG_IGN) {
      continue;
    }
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;  // a write that was interrupted goes on
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

Requests take_requests() {
  const Requests requests{checkpoint_requested != 0, stop_requested != 0};
  checkpoint_requested = 0;
  return requests;
}

}  // namespace brunt
