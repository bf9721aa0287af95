#include "app/signals.hpp"

#include <csignal>
#include <initializer_list>

namespace brunt {

namespace {
// A handler may only set a flag; the run reads it between steps.
volatile std::sig_atomic_t checkpoint_asked = 0;
volatile std::sig_atomic_t stop_asked = 0;

void on_signal(int signal) {
  if (signal == SIGUSR1) {
    checkpoint_asked = 1;
  } else {
    stop_asked = 1;
  }
}
}  // namespace

void listen_to_signals() {
  for (const int signal : {SIGUSR1, SIGUSR2, SIGTERM, SIGINT}) {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;  // a write that was interrupted goes on
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

Requests take_requests() {
  const Requests requests{checkpoint_asked != 0, stop_asked != 0};
  checkpoint_asked = 0;
  return requests;
}

}  // namespace brunt
