#include <fmt/core.h>

#include <solver/program/commands.hpp>

#include "scene_schema.hpp"

namespace pinball {

int schema_command(const SchemaOptions& options) {
  if (options.keys) {
    for (const std::string& key : settable_keys()) fmt::print("{}\n", key);
  } else {
    fmt::print("{}\n", scene_schema());
  }
  return 0;
}

}  // namespace pinball
