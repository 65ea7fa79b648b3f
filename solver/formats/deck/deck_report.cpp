#include "deck_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>

namespace pinball {

void DeckReport::count(std::vector<Count>& counts, const std::string& what, const DeckPlace& place,
                       const std::string& reason, int elements) {
  const auto same = [&](const Count& one) { return one.what == what && one.reason == reason; };
  auto found = std::ranges::find_if(counts, same);
  if (found == counts.end()) found = counts.insert(counts.end(), {what, reason, place, 0, elements >= 0});
  found->times += elements >= 0 ? elements : 1;
}

std::string DeckReport::line(const Count& one) {
  const std::string where = one.times == 1 ? one.first.text()
                                           : fmt::format("{} {}, first in {}", one.times,
                                                         one.of_elements ? "elements" : "times", one.first.text());
  return fmt::format("{} ({}){}", one.what, where, one.reason.empty() ? "" : ": " + one.reason);
}

void DeckReport::require_all_done(const std::string& file) const {
  if (rejected_.empty()) return;
  std::string text = fmt::format("{}: cannot be run, for this version has not:", file);
  for (const Count& one : rejected_) text += "\n  " + line(one);
  for (const std::string& error : errors_) text += "\nand besides: " + error;
  throw InputError(text);
}

std::vector<std::string> DeckReport::understood() const {
  std::vector<std::string> lines = understood_;
  for (const Count& one : left_out_)
    lines.push_back("left out, since --lenient says so, and may change the answer: " + line(one));
  for (const Count& one : unused_) lines.push_back("not used: " + line(one));
  return lines;
}

std::vector<std::string> DeckReport::ignored() const {
  std::vector<std::string> lines;
  for (const Count& one : ignored_) lines.push_back(line(one));
  return lines;
}

}  // namespace pinball
