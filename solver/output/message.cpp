#include "message.hpp"

#include <cstdio>

namespace pinball {

void print_message(const std::string& text) {
  std::fflush(stdout);  // in a log that both go to, what was printed before comes before
  std::fputs(("pinball: " + text + '\n').c_str(), stderr);
}

}  // namespace pinball
