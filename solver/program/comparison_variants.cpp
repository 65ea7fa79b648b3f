#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>

#include "comparison.hpp"

namespace pinball {

namespace {

/// One --vary, split.
struct Variation {
  std::string key;
  std::vector<std::string> values;
};

/// "a, [1, 2], 'b,c'" as its three values: commas in brackets and in quotes are part of a value.
std::vector<std::string> split_values(const std::string& text) {
  std::vector<std::string> values{""};
  int depth = 0;
  char quote = 0;
  for (const char c : text) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == ',' && depth == 0) {
      values.emplace_back();
      continue;
    }
    values.back() += c;
  }
  return values;
}

Variation parse_vary(const std::string& text) {
  const auto fail = [&text](const std::string& problem) {
    throw InputError(
        fmt::format("--vary {}: expected KEY=V1,V2,... as in contact.method=pinball,slideline{}", text, problem));
  };
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0) fail("");
  Variation variation{text.substr(0, equals), split_values(text.substr(equals + 1))};
  for (const std::string& value : variation.values) {
    if (value.find_first_not_of(' ') == std::string::npos) fail(", got an empty value");
  }
  return variation;
}

}  // namespace

std::vector<Variant> make_variants(const SceneSource& source, const std::vector<std::string>& vary) {
  std::vector<std::string> keys;
  std::vector<std::vector<std::string>> combinations{{}};
  for (const std::string& text : vary) {
    const Variation variation = parse_vary(text);
    if (std::find(keys.begin(), keys.end(), variation.key) != keys.end()) {
      throw InputError(fmt::format("--vary {}: {} is varied a second time", text, variation.key));
    }
    if (variation.key == "precision" && source.overrides.precision) {
      throw InputError(fmt::format("--vary {}: expected no --precision beside it", text));
    }
    keys.push_back(variation.key);
    std::vector<std::vector<std::string>> more;
    for (const auto& combination : combinations) {
      for (const std::string& value : variation.values) {
        more.push_back(combination);
        more.back().push_back(fmt::format("{}={}", variation.key, value));
      }
    }
    combinations = std::move(more);
  }
  std::vector<Variant> variants;
  for (const auto& settings : combinations) {
    SceneSource varied = source;
    varied.overrides.vary = settings;
    try {
      variants.push_back({settings, read_scene(varied)});
    } catch (const InputError& error) {
      const std::string problem = error.what();
      if (settings.empty() || (settings.size() == 1 && problem.starts_with("--vary "))) throw;  // names it already
      throw InputError(fmt::format("{} (with {})", problem, name_of(settings)));
    }
  }
  return variants;
}

}  // namespace pinball
