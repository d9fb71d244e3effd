// libFuzzer's door to one target of targets.hpp; CMake sets PLUMB_FUZZ_TARGET to its name.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::feed(plumb::fuzz::PLUMB_FUZZ_TARGET, {reinterpret_cast<const char*>(data), size});
  return 0;
}
