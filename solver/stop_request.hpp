#pragma once

namespace recoat {

/// From now on SIGINT and SIGTERM ask the run to stop after the steps in hand instead of ending the program.
void listen_for_stop();

/// The signal that asked to stop, or 0.
int stop_signal();

}  // namespace recoat
