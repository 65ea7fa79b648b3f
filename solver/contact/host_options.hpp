#pragma once

#include <pinball/contact/contact.h>

#include <pinball/contact/contact_settings.hpp>

namespace pinball {

/// The settings that a host's options name. Throws HostError for a value that there is not.
ContactSettings settings_of(const pinball_contact_options* options);

}  // namespace pinball
