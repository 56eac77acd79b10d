#include "core/base/stop_request.h"

#include <csignal>

namespace nilas {

namespace {

/// The only thing that a signal handler may touch.
volatile std::sig_atomic_t requested = 0;
void request(int) { requested = 1; }

}  // namespace

void listen_for_stop() {
  requested = 0;
  std::signal(SIGINT, request);
  std::signal(SIGTERM, request);
}

bool stop_requested() { return requested != 0; }

}  // namespace nilas
