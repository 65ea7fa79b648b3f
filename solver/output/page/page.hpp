#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// One file that opens anywhere: text, style, scripts and the numbers that these show, with no address outside of it.
namespace pinball {

/// For text and attributes. Bytes that are no UTF-8 become U+FFFD.
std::string html_text(const std::string& text);

/// JSON that may stand in a <script>: without "<", ">" and "&", which JSON has in texts alone.
std::string json_for_script(const std::string& json);

/// The template with each {{NAME}} replaced; a name that is not among the values is a resource. What is put in is not
/// looked through again.
std::string fill_template(std::string_view text, const std::vector<std::pair<std::string, std::string>>& values);

struct PageContent {
  std::string title;
  std::string body;                                         ///< HTML
  std::vector<std::string> scripts;                         ///< resources, in their order
  std::vector<std::pair<std::string, std::string>> blocks;  ///< id and JSON
};

/// Resources of a page with the viewer of bodies, in their order: what it needs, itself, and the page's own.
std::vector<std::string> scripts_with_viewer(const std::vector<std::string>& own);

std::string make_page(const PageContent& content);

}  // namespace pinball
