#pragma once

#include <new>
#include <string>

#include <kernels/exec/error_text.hpp>
#include <solver/scene.hpp>

namespace pinball {

/// A request for memory that failed, in words that took none.
class OutOfMemory : public std::bad_alloc {
 public:
  /// doing: "while the scene was built"; needed: what that takes at the least, 0: nobody knows [bytes].
  explicit OutOfMemory(const std::string& doing, double needed = 0);
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  ErrorText text_;
};

/// What a run of the scene takes at the least, as far as its meshes are generated or given as arrays [bytes].
double least_bytes(const Scene& scene);

}  // namespace pinball
