#pragma once

#include <string_view>

namespace pinball {

/// A file of this folder, or of the library that draws curves ("dygraph.min.js", "dygraph.min.css"), as it was when the
/// program was configured; empty for what was not found then.
std::string_view page_resource(std::string_view name);

}  // namespace pinball
