#include "memory_error.hpp"

#include <solver/output/out_of_memory.hpp>

namespace pinball {

std::string memory_error(const std::bad_alloc& error) {
  if (const auto* known = dynamic_cast<const OutOfMemory*>(&error)) return known->what();
  return OutOfMemory("").what();
}

}  // namespace pinball
