#pragma once

namespace brunt {

/// What a run is asked for from outside, between two steps.
struct Requests {
  bool checkpoint = false;  ///< write one now
  bool stop = false;        ///< write one and stop
};

/// From now on SIGUSR1 asks for a checkpoint; SIGUSR2, SIGTERM, SIGINT and SIGHUP
/// (unless it is ignored, as nohup does) for one and the end.
void listen_to_signals();

/// What signals have asked for since the last call; a stop stays asked for.
Requests take_requests();

}  // namespace brunt
