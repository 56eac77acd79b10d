#pragma once
/// The user's request to end a long command in order.

namespace nilas {

/// Makes SIGINT and SIGTERM set a request instead of ending the program; clears an earlier request.
void listen_for_stop();
/// Whether SIGINT or SIGTERM came since listen_for_stop().
bool stop_requested();

}  // namespace nilas
