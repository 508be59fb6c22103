#pragma once

namespace recoat {

/// Lets threads that wait for others at the end of a loop try again for some 0.4 ms and then sleep, instead of keeping
/// their processor for 10 ms and more: on a busy machine that is the time of the thread they wait for
/// [docs/performance.md]. The runtime of OpenMP reads this from the environment before main() begins, so the program
/// takes its own place once; nothing happens where the user has set OMP_WAIT_POLICY or GOMP_SPINCOUNT.
void wait_briefly(char** arguments);

}  // namespace recoat
