#include <fmt/core.h>

#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>
#include <solver/formats/deck_reader.hpp>
#include <solver/output/output_file.hpp>
#include <solver/scene.hpp>
#include <solver/scene/given/toml_file.hpp>

#include "commands.hpp"
#include "result_file.hpp"
#include "scene_input.hpp"

namespace pinball {

namespace fs = std::filesystem;

int convert_command(const ConvertOptions& options) {
  if (!is_any_deck(options.deck)) throw InputError(options.deck + ": expected a deck (.k, .key, .dyn, .inp, .rad)");
  if (!options.force && fs::exists(options.scene)) {
    throw InputError(options.scene + ": is there already; --force replaces it");
  }
  check_result_path("convert", options.scene);
  const fs::path folder = fs::absolute(options.scene).parent_path();
  const std::string deck = fs::absolute(options.deck).lexically_proximate(folder).string();
  const TranslatedDeck translated = translate_any_deck(options.deck, {options.chosen_case, options.lenient, deck});
  read_scene(translated.source(options.scene));  // what would not be read is not written
  const std::string text = write_toml(translated.given->table);
  parse_toml(text, options.scene);  // of bytes that no text can have
  OutputFile file(options.scene);
  file.write(text);
  file.commit();
  print_deck(translated, options.deck);
  fmt::print("{} is the scene; its meshes are read from {}\n", options.scene, deck);
  return 0;
}

}  // namespace pinball
