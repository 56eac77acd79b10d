#pragma once
/// Ends what clients of a server of this program keep open.

namespace nilas::view {

/// Ends all connections of this program whose own end is this TCP port. Whoever waits for their bytes goes on at once.
/// Linux only; elsewhere it does nothing.
void end_connections(int port);

}  // namespace nilas::view
