#pragma once

#include <memory>
#include <string>
#include <vector>

#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/contact.h>
#include <solver/contact/contact_settings.hpp>

#include "host_surface.hpp"

namespace pinball {

/// Contact in the time loop of a host: what the C interface calls. Throws HostError for wrong arguments, after which it
/// is as before the call.
class HostContact {
 public:
  virtual ~HostContact() = default;
  virtual void update(const pinball_contact_arrays* arrays, double dt_before) = 0;
  virtual pinball_contact_result add_forces(const pinball_contact_arrays* arrays, double dt_after) = 0;
  virtual std::int32_t surface_elements() const = 0;
  /// What a host ought to know of what it has asked for; empty: nothing.
  virtual const std::string& warning() const = 0;
};

/// Of the number type that the options name.
std::unique_ptr<HostContact> make_host_contact(const pinball_contact_options* options, const pinball_contact_mesh* mesh,
                                               const pinball_contact_input* position);

}  // namespace pinball
