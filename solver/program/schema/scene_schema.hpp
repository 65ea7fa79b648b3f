#pragma once

#include <string>
#include <vector>

/// What scene files may hold, for editors and shells.
namespace pinball {

/// JSON Schema (draft 7) of scene files. Beside what it says to all: `x-unit`, of T, L and M, and `x-default`, in
/// words.
std::string scene_schema();

/// Keys of the tables of which a scene has one, as --set takes them: "time.end".
std::vector<std::string> settable_keys();

}  // namespace pinball
