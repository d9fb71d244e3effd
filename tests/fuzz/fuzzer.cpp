// libFuzzer's door to one target of targets.hpp; CMake sets PLUMB_FUZZ_TARGET to its name.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#ifdef PLUMB_FUZZ_POINTS  // the readers of points and tables need little else
#include "tests/fuzz/points.hpp"
#else
#include "tests/fuzz/targets.hpp"
#endif

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // a second of CPU time: libFuzzer's own -timeout looks at the clock, and a busy machine would raise false
  // alarms
  const std::clock_t start = std::clock();
  plumb::fuzz::feed(plumb::fuzz::PLUMB_FUZZ_TARGET, {reinterpret_cast<const char*>(data), size});
  if (std::clock() - start > CLOCKS_PER_SEC) {
    std::fputs("ERROR: hang: this input took more than a second of CPU time\n", stderr);
    std::abort();
  }
  return 0;
}
