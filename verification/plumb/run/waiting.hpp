#pragma once

namespace plumb::app {

/// Lets OpenMP threads that wait for work sleep instead of turning in a loop, which takes the processor from
/// every other program. The runtime reads this from the environment before main() begins, so the program
/// starts itself again with it, under the same process number and with the same `arguments` (those of
/// main()). Does nothing if the user has chosen otherwise, or if there is one processor only.
void let_waiting_threads_sleep(char** arguments);

}  // namespace plumb::app
