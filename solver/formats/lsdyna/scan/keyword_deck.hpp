#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <solver/mesh.hpp>

#include "included_files.hpp"
#include "keyword_block.hpp"
#include "parameters.hpp"

namespace pinball {

/// An LS-DYNA keyword deck: the keywords of all its files in their order, those of one case. What a file says of files
/// (*INCLUDE, *INCLUDE_PATH, *INCLUDE_TRANSFORM), of cases and of parameters is done here, *KEYWORD and *END too.
struct KeywordDeck {
  std::vector<KeywordBlock> blocks;
  Parameters parameters;
  std::vector<MeshSource> files;                          ///< as opened, the deck itself first
  std::vector<std::int64_t> cases;                        ///< numbers that --case takes
  std::size_t left_out_of_case = 0;                       ///< keywords that belong to other cases
  bool case_is_empty = false;                             ///< the chosen *CASE lists no numbers
  std::vector<UnreadLine> unread;                         ///< of what is done here
  std::vector<DeckPlace> behind_end;                      ///< where in its files more stands behind *END
  std::vector<std::shared_ptr<const std::string>> texts;  ///< what the blocks refer to
};

/// Throws InputError "FILE:LINE: ..." for a file that is missing or includes itself, for an unknown format or case and
/// for what is no keyword deck.
KeywordDeck read_keyword_deck(const std::string& path, std::optional<std::int64_t> chosen_case = {});

/// The same for a text in memory; `name` stands for the path.
KeywordDeck parse_keyword_deck(std::string text, const std::string& name, std::optional<std::int64_t> chosen_case = {});

}  // namespace pinball
