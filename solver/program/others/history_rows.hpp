#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string>

#include "other_history.hpp"

namespace pinball {

inline constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

/// Rows by time, of curves that come and go.
class Rows {
 public:
  explicit Rows(OtherHistory& history) : history_(history) {}

  void begin(double time) {
    while (!history_.times.empty() && history_.times.back() >= time) {  // taken up again
      history_.times.pop_back();
      for (OtherCurve& curve : history_.curves) curve.values.resize(history_.times.size());
    }
    history_.times.push_back(time);
    for (OtherCurve& curve : history_.curves) curve.values.push_back(not_there);
  }
  bool empty() const { return history_.times.empty(); }
  template <class MeaningOf>
  void set(const std::string& name, double value, const MeaningOf& meaning) {
    const auto [place, is_new] = place_.try_emplace(name, history_.curves.size());
    if (is_new) history_.curves.push_back({name, meaning(name), std::vector<double>(history_.times.size(), not_there)});
    history_.curves[place->second].values.back() = value;
  }

 private:
  OtherHistory& history_;
  std::map<std::string, std::size_t> place_;
};

}  // namespace pinball
