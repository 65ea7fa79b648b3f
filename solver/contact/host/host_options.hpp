#pragma once

#include <solver/contact/contact.h>
#include <solver/contact/contact_settings.hpp>

namespace pinball {

/// The settings that a host's options name. Throws HostError for a value that there is not.
ContactSettings settings_of(const pinball_contact_options* options);

}  // namespace pinball
