#pragma once

#include <new>
#include <string>

#include <solver/base/export.h>

namespace pinball {

/// What to say of a request for memory that failed, whoever made it.
PINBALL_API std::string memory_error(const std::bad_alloc& error);

}  // namespace pinball
