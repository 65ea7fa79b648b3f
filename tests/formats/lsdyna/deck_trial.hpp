#pragma once

#include <string>

#include <solver/base/error.hpp>
#include <solver/formats/lsdyna/cards/keyword_scene.hpp>
#include <solver/model/model.hpp>
#include <solver/scene.hpp>

namespace pinball::test {

enum class TrialEnd { model, refused };

/// A deck as far as its model: read, translated, its scene read, its model built. What is thrown besides InputError is
/// a defect, and so is a deck that takes the sanitizers, the memory or the time of whoever tries it.
inline TrialEnd try_deck(const std::string& path) {
  try {
    const TranslatedDeck deck = translate_deck(path);
    build_model<double>(read_scene(deck.source(path)));
    return TrialEnd::model;
  } catch (const InputError&) {
    return TrialEnd::refused;
  }
}

}  // namespace pinball::test
