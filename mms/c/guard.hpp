#pragma once
#include <functional>
#include <string>

#include "mms/c/plumbline.h"

namespace plumb::c {

/// Does the work and gives PLUMB_OK; of what is thrown it keeps the message for plumb_message().
plumb_status guarded(const std::function<void()>& work) noexcept;

/// Throws InputError for a null pointer that must not be one; `what` names it.
void require(const void* pointer, const char* what);

}  // namespace plumb::c
