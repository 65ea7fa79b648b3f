#pragma once

#include <exception>
#include <string>

#include <solver/base/message.hpp>
#include <solver/contact/contact.h>

namespace pinball {

/// What a host has done wrong: becomes a status and a message of the C interface.
class HostError : public std::exception {
 public:
  template <class... Parts>
  explicit HostError(pinball_contact_status status, const Parts&... parts)
      : status_(status), message_(message_of(parts...)) {}
  pinball_contact_status status() const { return status_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  pinball_contact_status status_;
  std::string message_;
};

/// What messages say of numbers that are not finite, or too large.
inline constexpr const char* unsound = ": expected numbers whose squares are finite";

inline void require_pointer(const void* pointer, const char* name) {
  if (pointer == nullptr) throw HostError(PINBALL_CONTACT_NULL_POINTER, name, ": is null");
}

template <class Struct>
void require_version(const Struct* given, const char* name) {
  require_pointer(given, name);
  if (given->size != sizeof(Struct)) {
    throw HostError(PINBALL_CONTACT_BAD_VERSION, name, "->size: ", given->size, " is not ", sizeof(Struct),
                    ": was it filled by its init function, of the same version?");
  }
}

}  // namespace pinball
