#pragma once
/// The user's request to end a long command in order.

namespace nilas {

/// From now on SIGINT and SIGTERM no longer end the program but are remembered; forgets an earlier request.
void listen_for_stop();
/// Whether SIGINT or SIGTERM came since listen_for_stop().
bool stop_requested();

}  // namespace nilas
