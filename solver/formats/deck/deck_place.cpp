#include "deck_place.hpp"

#include <solver/base/error.hpp>

namespace pinball {

void fail_at(const DeckPlace& place, const std::string& problem) { throw InputError(place.text() + ": " + problem); }

}  // namespace pinball
