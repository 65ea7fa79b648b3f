#pragma once

#include <string>
#include <vector>

/// Histories that other programs have written of the same model, to be laid beside a run of this one.
namespace pinball {

/// What of this program's history a quantity of another program is: a sum of columns.
struct Meaning {
  std::vector<std::string> columns{};  ///< of history.csv; empty: nothing here is the same
  bool per_mass = false;               ///< the sum over the mass of the model
};

struct OtherCurve {
  std::string name;  ///< as the file has it
  Meaning meaning;
  std::vector<double> values{};  ///< one per time; NaN where the file has no number
};

struct OtherHistory {
  std::string path;
  std::string kind;  ///< "glstat of LS-DYNA", "nodout of LS-DYNA", "dat of CalculiX", "T01 of Radioss", "binout of
                     ///< LS-DYNA", "d3plot of LS-DYNA", perhaps with how many of its states, or "table"
  std::vector<double> times;  ///< rising [time]
  std::vector<OtherCurve> curves;
};

/// Reads what LS-DYNA writes as text (glstat, nodout), as a binout or as a d3plot, CalculiX' .dat, T01 files of Radioss
/// and tables whose first line has names, with commas, semicolons, tabs or blanks between the columns: history.csv,
/// what OpenRadioss' th_to_csv and Abaqus' XY reports write, and those of spreadsheets. Where a time comes again, or an
/// earlier one, the run was taken up again there: what comes later counts. Throws InputError that names file and line,
/// or byte.
OtherHistory read_other_history(const std::string& path);

/// A name of a quantity in lower case, with a blank for whatever separates words, without a unit in brackets.
std::string plain_name(const std::string& name);

/// The meaning of a quantity of a table by its name, whatever its case and separators: "KINETIC ENERGY", "ALLKE",
/// "X-MOMENTUM". A name that is none of another program's means the column of that name.
Meaning meaning_of_column(const std::string& name);

/// The same of a line of LS-DYNA's glstat.
Meaning meaning_in_glstat(const std::string& name);

}  // namespace pinball
