#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "keyword_block.hpp"
#include "parameters.hpp"

namespace pinball {

/// Which keywords belong to which case: *CASE, *CASE_BEGIN_n ... *CASE_END_n, and CID=n behind a keyword.
class DeckCases {
 public:
  using Numbers = std::set<std::int64_t>;

  explicit DeckCases(std::optional<std::int64_t> chosen) : chosen_(chosen) {}

  /// Takes in a keyword of cases; false: it is none. Throws InputError for an end without a beginning.
  bool take_in(const KeywordBlock& block, const Parameters& parameters);
  /// The numbers that a keyword belongs to, here; none: to all cases. after: what stands behind its name.
  Numbers cases_here(const std::string& after) const;
  /// Whether what belongs to these is of the chosen case.
  bool takes(const Numbers& cases) const;
  /// Remembers that there are such numbers.
  void know(const Numbers& cases) { known_.insert(cases.begin(), cases.end()); }
  /// Whether there is a *CASE of the chosen number that lists no others: nothing belongs to it.
  bool chosen_is_empty() const;
  /// What --case takes: first the numbers of *CASE.
  std::vector<std::int64_t> numbers() const;

 private:
  void begin_or_end(const KeywordBlock& block);
  void read_case(const KeywordBlock& block, const Parameters& parameters);

  std::optional<std::int64_t> chosen_;
  Numbers open_, known_;
  std::map<std::int64_t, Numbers> members_;  ///< per *CASE
};

}  // namespace pinball
