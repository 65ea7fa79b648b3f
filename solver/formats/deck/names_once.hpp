#pragma once

#include <fmt/format.h>

#include <set>
#include <string>

namespace pinball {

/// Names of the bodies of a deck, each given once.
class NamesOnce {
 public:
  /// The name itself; where it is empty or taken the other one, with a number behind it where that is taken, too.
  std::string take(const std::string& name, const std::string& other) {
    if (!name.empty() && taken_.insert(name).second) return name;
    std::string free = other;
    for (int n = 2; !taken_.insert(free).second; ++n) free = fmt::format("{}_{}", other, n);
    return free;
  }

 private:
  std::set<std::string> taken_;
};

}  // namespace pinball
