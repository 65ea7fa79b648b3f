#pragma once

#include <charconv>
#include <cstddef>
#include <cstring>

namespace pinball {

/// The text of an error without memory of its own; what does not fit is cut off.
class ErrorText {
 public:
  ErrorText& operator<<(const char* words) { return add(words, std::strlen(words)); }
  ErrorText& operator<<(std::size_t number) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
    return add(digits, static_cast<std::size_t>(end - digits));
  }
  const char* c_str() const { return text_; }

 private:
  ErrorText& add(const char* words, std::size_t count) {
    const std::size_t room = sizeof text_ - 1 - size_;
    if (count > room) count = room;
    std::memcpy(text_ + size_, words, count);
    size_ += count;
    return *this;
  }

  char text_[512] = {};
  std::size_t size_ = 0;
};

}  // namespace pinball
