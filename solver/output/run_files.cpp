#include "run_files.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace pinball {

namespace {

bool is_any_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_number(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// fields_0000.vtu
bool is_field_file(std::string_view name) {
  const std::string prefix = std::string(fields_base) + '_';
  if (!name.starts_with(prefix)) return false;
  name.remove_prefix(prefix.size());
  for (const std::string_view suffix : {".pvtu", ".vtu"}) {
    if (name.ends_with(suffix)) return is_field_number(name.substr(0, name.size() - suffix.size()));
  }
  return false;
}

}  // namespace

std::string in_folder(const std::string& folder, std::string_view name) {
  return (std::filesystem::path(folder) / name).string();
}

bool is_field_number(std::string_view text) {
  const std::size_t end = std::min(text.find('_'), text.size());
  return is_number(text.substr(0, end)) && (end == text.size() || is_number(text.substr(end + 1)));
}

bool is_run_file(const std::string& name) {
  constexpr std::string_view part = ".part";  // of a file that was being written (OutputFile)
  std::string_view whole = name;
  if (whole.ends_with(part)) whole.remove_suffix(part.size());
  return is_any_of(whole,
                   {summary_name, history_name, checkpoint_name, last_good_name, last_good_picture_name, page_name}) ||
         whole == std::string(fields_base) + ".pvd" || is_field_file(whole);
}

bool is_made_of_run(const std::string& name) {
  const std::filesystem::path path(name);
  const std::string stem = path.stem().string(), kind = path.extension().string();
  return is_any_of(name, {"fields.png", "fields_paraview.py", "history.png", study_settings_name}) ||
         (is_any_of(stem, {"view", "animation"}) &&
          is_any_of(kind, {".png", ".gif", ".mp4", ".webm", ".webp", ".html", ".pvsm"}));
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder, bool (*takes)(const std::string&)) {
  std::vector<std::filesystem::path> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
    const bool file = entry.is_symlink(error) || entry.is_regular_file(error);
    if (file && takes(entry.path().filename().string())) found.push_back(entry.path());
  }
  return found;
}

std::filesystem::path no_file_in(const std::filesystem::path& folder) {
  std::filesystem::path first;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? "." : folder, error)) {
    const bool file = entry.is_symlink(error) || entry.is_regular_file(error);
    if (file || !is_run_file(entry.path().filename().string())) continue;
    if (first.empty() || entry.path() < first) first = entry.path();
  }
  return first;
}

std::vector<std::filesystem::path> results_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> found = files_of(folder, is_run_file);
  const bool of_run = std::any_of(found.begin(), found.end(), [](const std::filesystem::path& path) {
    return path.filename() == summary_name || path.filename() == history_name;
  });
  if (of_run) {
    const auto made = files_of(folder, is_made_of_run);
    found.insert(found.end(), made.begin(), made.end());
  }
  return found;
}

}  // namespace pinball
