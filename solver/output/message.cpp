#include "message.hpp"

#include <cstdio>

namespace pinball {

void print_message(const std::string& text) { std::fputs(("pinball: " + text + '\n').c_str(), stderr); }

}  // namespace pinball
