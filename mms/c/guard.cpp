#include "mms/c/guard.hpp"

#include <new>

#include "lib/core/error.hpp"

namespace plumb::c {
namespace {

/// The last message of this thread. It must not throw in its turn: what cannot be kept is said by a literal.
struct Message {
  std::string kept;
  const char* text = "";
};
thread_local Message last;

void keep(const char* text) noexcept {
  try {
    last.kept = text;
    last.text = last.kept.c_str();
  } catch (...) {
    last.text = "out of memory";
  }
}

}  // namespace

plumb_status guarded(const std::function<void()>& work) noexcept {
  try {
    work();
    return PLUMB_OK;
  } catch (const InputError& error) {
    keep(error.what());
    return PLUMB_BAD_INPUT;
  } catch (const std::bad_alloc&) {
    last.text = "out of memory";
  } catch (const std::exception& error) {
    keep(error.what());
  } catch (...) {
    last.text = "unknown failure";
  }
  return PLUMB_FAILED;
}

void require(const void* pointer, const char* what) {
  if (pointer == nullptr)
    throw InputError(std::string(what) + " is a null pointer", "it must point to something", "");
}

}  // namespace plumb::c

extern "C" {
const char* plumb_message(void) {
  return plumb::c::last.text;
}
int plumb_interface(void) {
  return PLUMB_INTERFACE;
}
const char* plumb_version(void) {
  return PLUMBLINE_VERSION;
}
}
