#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace pinball {

class CardLayout;

/// What of a deck somebody has asked for: lines, fields of lines and parameters of keywords. What is left when all is
/// translated stands in the deck and has not become anything, which is reported, whoever has forgotten it.
class ReadingLog {
 public:
  /// So many lines of a keyword have been read. The keyword has to stay where it is.
  void reached(const void* keyword, std::size_t lines) {
    std::size_t& furthest = lines_[keyword];
    furthest = furthest < lines ? lines : furthest;
  }
  /// Fields of a line by their bits, and what the line may have; null: nobody says.
  struct Left {
    std::uint32_t fields = 0;
    const CardLayout* layout = nullptr;
  };
  /// Of the line whose text begins there these fields say something and were not asked for.
  void left(const char* line, std::uint32_t fields, const CardLayout* layout = nullptr) {
    const auto [found, is_new] = left_.try_emplace(line, Left{fields, layout});
    if (!is_new) found->second.fields &= fields;
  }
  /// A parameter of a keyword, by its place, has been asked for.
  void asked(const void* keyword, std::size_t parameter) {
    if (parameter < 32) parameters_[keyword] |= 1U << parameter;
  }
  /// Nothing is left of a keyword, which is reported by other means.
  void done(const void* keyword) { reached(keyword, -1); }

  bool is_done(const void* keyword) const { return lines_of(keyword) == static_cast<std::size_t>(-1); }
  /// Whether anybody has looked into it.
  bool has_seen(const void* keyword) const { return lines_.contains(keyword) || parameters_.contains(keyword); }
  std::size_t lines_of(const void* keyword) const {
    const auto found = lines_.find(keyword);
    return found == lines_.end() ? 0 : found->second;
  }
  Left left_of(const char* line) const {
    const auto found = left_.find(line);
    return found == left_.end() ? Left{} : found->second;
  }
  bool has_asked(const void* keyword, std::size_t parameter) const {
    const auto found = parameters_.find(keyword);
    return parameter >= 32 || (found != parameters_.end() && (found->second >> parameter & 1U) != 0);
  }

 private:
  std::unordered_map<const void*, std::size_t> lines_;
  std::unordered_map<const char*, Left> left_;
  std::unordered_map<const void*, std::uint32_t> parameters_;
};

}  // namespace pinball
