#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "contact.h"

/// The C interface of contact (contact.h, which explains the life of a step) for C++ hosts. All of it is in this
/// header, over the C interface: what lies between host and library does not depend on how either was compiled.
namespace pinball {

/// A call that failed; what() is pinball_contact_message.
class EmbeddedContactError : public std::runtime_error {
 public:
  /// status: pinball_contact_status.
  EmbeddedContactError(int status, const char* message) : std::runtime_error(message), status_(status) {}
  int status() const { return status_; }  ///< pinball_contact_status

 private:
  int status_;
};

/// Structs of the C interface with their defaults.
inline pinball_contact_options contact_options() {
  pinball_contact_options options;
  pinball_contact_options_init(&options);
  return options;
}
/// The same.
inline pinball_contact_mesh contact_mesh() {
  pinball_contact_mesh mesh;
  pinball_contact_mesh_init(&mesh);
  return mesh;
}
/// The same.
inline pinball_contact_arrays contact_arrays() {
  pinball_contact_arrays arrays;
  pinball_contact_arrays_init(&arrays);
  return arrays;
}

/// Vectors x, y, z of one node after the other; stride: numbers from node to node, 3 or more.
template <class S>
pinball_contact_input interleaved(const S* vectors, std::ptrdiff_t stride = 3) {
  return {vectors, vectors + 1, vectors + 2, stride};
}
/// The same for forces.
template <class S>
pinball_contact_output interleaved_sums(S* vectors, std::ptrdiff_t stride = 3) {
  return {vectors, vectors + 1, vectors + 2, stride};
}

/// One contact problem. It may be moved, not copied. Functions throw EmbeddedContactError where the C functions return
/// an error; after one of wrong arguments the contact and the arrays of the host are as before the call.
class EmbeddedContact {
 public:
  /// As pinball_contact_create.
  EmbeddedContact(const pinball_contact_options& options, const pinball_contact_mesh& mesh,
                  const pinball_contact_input& position) {
    const int status = pinball_contact_create(&options, &mesh, &position, &contact_);
    if (status == PINBALL_CONTACT_OK) return;
    const EmbeddedContactError error(status, contact_ != nullptr ? message() : "out of memory");
    pinball_contact_destroy(contact_);
    throw error;
  }
  ~EmbeddedContact() { pinball_contact_destroy(contact_); }
  /// Leaves an object that may only be destroyed or assigned to.
  EmbeddedContact(EmbeddedContact&& other) noexcept : contact_(std::exchange(other.contact_, nullptr)) {}
  /// The other one takes what this one was.
  EmbeddedContact& operator=(EmbeddedContact&& other) noexcept {
    std::swap(contact_, other.contact_);
    return *this;
  }
  EmbeddedContact(const EmbeddedContact&) = delete;
  EmbeddedContact& operator=(const EmbeddedContact&) = delete;

  /// As pinball_contact_update.
  void update(const pinball_contact_arrays& arrays, double dt_before) {
    require(pinball_contact_update(contact_, &arrays, dt_before));
  }
  /// As pinball_contact_add_forces.
  pinball_contact_result add_forces(const pinball_contact_arrays& arrays, double dt_after) {
    pinball_contact_result result;
    require(pinball_contact_add_forces(contact_, &arrays, dt_after, &result));
    return result;
  }
  /// For what the C interface alone can do.
  pinball_contact* handle() { return contact_; }

 private:
  const char* message() const { return pinball_contact_message(contact_); }
  void require(int status) const {
    if (status != PINBALL_CONTACT_OK) throw EmbeddedContactError(status, message());
  }

  pinball_contact* contact_ = nullptr;
};

}  // namespace pinball
