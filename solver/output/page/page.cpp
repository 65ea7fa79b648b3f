#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <solver/base/version.h>

#include "resources.hpp"

namespace pinball {

namespace {

std::string replaced(std::string_view text, const std::vector<std::pair<char, std::string_view>>& characters) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    std::string_view instead(&c, 1);
    for (const auto& [character, replacement] : characters) {
      if (c == character) instead = replacement;
    }
    result += instead;
  }
  return result;
}

}  // namespace

std::string html_text(const std::string& text) {
  using Json = nlohmann::json;
  // As a string of JSON and back: that replaces what is no UTF-8.
  const std::string valid =
      Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
  return replaced(valid, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}});
}

std::string json_for_script(const std::string& json) {
  return replaced(json, {{'<', "\\u003c"}, {'>', "\\u003e"}, {'&', "\\u0026"}});
}

std::string fill_template(std::string_view text, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string result;
  for (;;) {
    const auto begin = text.find("{{");
    const auto end = begin == std::string_view::npos ? begin : text.find("}}", begin);
    if (end == std::string_view::npos) return result.append(text);
    result.append(text.substr(0, begin));
    const std::string_view name = text.substr(begin + 2, end - begin - 2);
    std::string_view value = page_resource(name);
    for (const auto& [key, given] : values) {
      if (key == name) value = given;
    }
    result.append(value);
    text.remove_prefix(end + 2);
  }
}

std::vector<std::string> scripts_with_viewer(const std::vector<std::string>& own) {
  std::vector<std::string> scripts{"format.js",         "axes.js",          "curves.js",         "plot.js",
                                   "viewer_data.js",    "viewer_camera.js", "viewer_drawing.js", "viewer_surround.js",
                                   "viewer_picking.js", "viewer.js",        "viewer_pointer.js", "viewer_alone.js"};
  scripts.insert(scripts.end(), own.begin(), own.end());
  return scripts;
}

std::string make_page(const PageContent& content) {
  std::string blocks, script;
  for (const auto& [id, json] : content.blocks) {
    blocks += fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id, json_for_script(json));
  }
  const bool curves = std::find(content.scripts.begin(), content.scripts.end(), "curves.js") != content.scripts.end();
  const std::string library =
      fmt::format("<script>\n{}{}\n</script>", page_resource("dygraphs_licence.js"), page_resource("dygraph.min.js"));
  for (const std::string& name : content.scripts) script.append(page_resource(name)).append("\n");
  return fill_template(page_resource("page.html"),
                       {{"version", PINBALL_VERSION},
                        {"curve style", std::string(page_resource(curves ? "dygraph.min.css" : ""))},
                        {"curve script", curves ? library : ""},
                        {"title", html_text(content.title)},
                        {"body", content.body},
                        {"blocks", blocks},
                        {"script", script}});
}

}  // namespace pinball
