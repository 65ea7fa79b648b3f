#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The names of all files that a run leaves in its folder, and that commands make of it afterwards: what a new run
/// removes. A name that is not here is never touched.
namespace pinball {

inline constexpr const char* summary_name = "summary.json";
inline constexpr const char* history_name = "history.csv";
inline constexpr const char* checkpoint_name = "checkpoint.pinball";
inline constexpr const char* last_good_name = "last_good.pinball";
inline constexpr const char* last_good_picture_name = "last_good.vtu";
inline constexpr const char* page_name = "index.html";
inline constexpr const char* fields_base =
    "fields";  ///< fields.pvd, fields_0000.vtu, ...; of ranks fields_0000.pvtu, fields_0000_0.vtu, ...
inline constexpr const char* study_settings_name = "study_settings.txt";  ///< of a run of `pinball converge`
inline constexpr const char* lock_name = "pinball.lock";

/// The file of the folder, which may be empty.
std::string in_folder(const std::string& folder, std::string_view name);

/// Whether this stands between the base and the ending of a file of fields: 0000, of a piece 0000_0.
bool is_field_number(std::string_view text);

/// Whether a run writes a file of this name; the lock is none of its results.
bool is_run_file(const std::string& name);

/// Whether commands make a file of this name of a run: fields.png, fields.pvsm, history.png, view.*, animation.*, and
/// study_settings.txt.
bool is_made_of_run(const std::string& name);

/// Files of a folder that one of these functions takes, links among them; no folders.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder, bool (*takes)(const std::string&));

/// What has the name of a run's file and is neither file nor link: the first one by name; empty: there is none.
std::filesystem::path no_file_in(const std::filesystem::path& folder);

/// What runs and commands have left in a folder. What commands make has names that others use, too: they count where a
/// run's summary or history is beside them.
std::vector<std::filesystem::path> results_in(const std::filesystem::path& folder);

}  // namespace pinball
