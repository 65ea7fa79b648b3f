#include <cmath>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/contact/contact.h>

#include "host_contact.hpp"
#include "host_error.hpp"

/// The C interface: calls of HostContact, whose exceptions become statuses and messages.

struct pinball_contact {
  std::unique_ptr<pinball::HostContact> contact;  ///< null after an error of creation
  pinball_contact_log_hook log = nullptr;
  void* log_user = nullptr;
  pinball_contact_assert_hook failed = nullptr;
  void* failed_user = nullptr;
  std::string message;
  bool broken = false;  ///< an internal check failed
};

namespace {

/// What hooks throw goes no further: they are informed, and not asked.
template <class Hook>
void call_hook(const Hook& hook) noexcept {
  try {
    hook();
  } catch (...) {
  }
}

void tell(const pinball_contact& of, pinball_contact_log_level level, const char* message) noexcept {
  if (of.log != nullptr) call_hook([&] { of.log(of.log_user, level, message); });
}

int fail(pinball_contact& of, pinball_contact_status status, const char* message) noexcept {
  try {
    of.message = message;
  } catch (...) {  // without memory for it
    of.message.clear();
  }
  tell(of, PINBALL_CONTACT_ERROR, message);
  return status;
}

int fail_check(pinball_contact& of, const char* expression, int line) noexcept {
  of.broken = true;
  if (of.failed != nullptr) call_hook([&] { of.failed(of.failed_user, expression, __FILE__, line); });
  return fail(of, PINBALL_CONTACT_FAILED, expression);
}

/// Runs work(), which returns a status.
template <class Work>
int guarded(pinball_contact& of, const Work& work) noexcept {
  of.message.clear();
  if (of.broken) return fail(of, PINBALL_CONTACT_FAILED, "an internal check failed before");
  try {
    return work();
  } catch (const pinball::HostError& error) {
    return fail(of, error.status(), error.what());
  } catch (const pinball::InputError& error) {
    return fail(of, PINBALL_CONTACT_BAD_MESH, error.what());
  } catch (const std::bad_alloc&) {
    of.broken = of.contact != nullptr;  // in the midst of a step
    return fail(of, PINBALL_CONTACT_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return fail_check(of, error.what(), __LINE__);
  } catch (...) {
    return fail_check(of, "nothing unknown is thrown", __LINE__);
  }
}

template <class Struct>
void clear(Struct* of) {
  if (of == nullptr) return;
  *of = {};
  of->size = sizeof(Struct);
}

}  // namespace

void pinball_contact_options_init(pinball_contact_options* options) {
  clear(options);
  if (options == nullptr) return;
  options->gap = PINBALL_CONTACT_GAP_FACE;
  options->self = 1;
  options->keep_lists = 1;
  options->beta = 1;
  options->damping = 0.1;
  options->static_friction = -1;
  options->radius_factor = 1;
  options->skin = 0.5;
}

void pinball_contact_mesh_init(pinball_contact_mesh* mesh) { clear(mesh); }

void pinball_contact_arrays_init(pinball_contact_arrays* arrays) { clear(arrays); }

int pinball_contact_create(const pinball_contact_options* options, const pinball_contact_mesh* mesh,
                           const pinball_contact_input* position, pinball_contact** contact) {
  if (contact == nullptr) return PINBALL_CONTACT_NULL_POINTER;
  *contact = new (std::nothrow) pinball_contact;
  if (*contact == nullptr) return PINBALL_CONTACT_OUT_OF_MEMORY;
  pinball_contact& of = **contact;
  if (options != nullptr && options->size == sizeof(*options)) {
    of.log = options->log;
    of.log_user = options->log_user;
    of.failed = options->failed;
    of.failed_user = options->failed_user;
  }
  return guarded(of, [&]() -> int {
    of.contact = pinball::make_host_contact(options, mesh, position);
    if (of.log != nullptr) {
      const std::string note =
          pinball::message_of(of.contact->surface_elements(), " elements and spheres with an exposed face");
      tell(of, PINBALL_CONTACT_NOTE, note.c_str());
    }
    of.message = of.contact->warning();
    if (!of.message.empty()) tell(of, PINBALL_CONTACT_WARNING, of.message.c_str());
    return PINBALL_CONTACT_OK;
  });
}

void pinball_contact_destroy(pinball_contact* contact) { delete contact; }

int pinball_contact_update(pinball_contact* contact, const pinball_contact_arrays* arrays, double dt_before) {
  if (contact == nullptr) return PINBALL_CONTACT_NULL_POINTER;
  return guarded(*contact, [&]() -> int {
    if (!contact->contact) throw pinball::HostError(PINBALL_CONTACT_BAD_ORDER, "contact: it was not created");
    contact->contact->update(arrays, dt_before);
    return PINBALL_CONTACT_OK;
  });
}

int pinball_contact_add_forces(pinball_contact* contact, const pinball_contact_arrays* arrays, double dt_after,
                               pinball_contact_result* result) {
  if (contact == nullptr) return PINBALL_CONTACT_NULL_POINTER;
  return guarded(*contact, [&]() -> int {
    if (!contact->contact) throw pinball::HostError(PINBALL_CONTACT_BAD_ORDER, "contact: it was not created");
    const pinball_contact_result now = contact->contact->add_forces(arrays, dt_after);
    if (!std::isfinite(now.stored + now.dissipated + now.eroded + now.frequency2)) {
      return fail_check(*contact, "energies and frequency of the contact are finite", __LINE__);
    }
    if (result != nullptr) *result = now;
    return PINBALL_CONTACT_OK;
  });
}

const char* pinball_contact_message(const pinball_contact* contact) {
  return contact != nullptr ? contact->message.c_str() : "contact: is null";
}
