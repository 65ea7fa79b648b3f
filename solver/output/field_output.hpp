#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <solver/field_base.hpp>
#include <solver/results.hpp>

#include "field_pieces.hpp"

namespace pinball {

/// Writes field output for ParaView: FOLDER/BASE_0000.vtu, _0001, ... and FOLDER/BASE.pvd, which lists them with their
/// times. The list is renewed after every write and each file appears complete, so ParaView opens a running job.
///
/// Point data: velocity (3 components) with displacement (3), contact_force (3). Cell data: stress (xx yy zz xy yz zx)
/// with von_mises and pressure (positive in compression), plastic_strain, pinball_radius, where asked for
/// triaxiality, temperature and damage, and always alive (UInt8) and body (Int32): eroded elements stay in the file,
/// with alive = 0, and are hidden with a threshold on it. Where mesh files give numbers, node_number and element_number
/// (Int64; -1: from no file). Positions are Float64, fields Float32. The scene's unit names are in a comment at the
/// head of each file, the names of the bodies in its field data: strings `body_names`, of which that of body i is
/// number i.
class FieldWriter {
 public:
  using Written = std::vector<std::pair<double, std::string>>;  ///< time, file name

  /// Makes the folder and removes BASE.pvd, BASE_<digits>.vtu and pieces that an earlier run left there, but for the
  /// files that are `kept`: the list begins with those of them that are there. `fields`: names as in
  /// OutputSettings::fields, empty for all; a field whose array in the snapshot is empty (the run did not need it) is
  /// left out. `units`: the scene's string. `bodies`: their names, in the order of their numbers. `base`: its views
  /// have to be valid as long as this writes; without initial positions there are no displacements. Throws InputError
  /// for an unknown name, RunError where the folder cannot be made.
  FieldWriter(std::string folder, std::string base_name, std::vector<std::string> fields = {}, std::string units = {},
              const Written& kept = {}, std::vector<std::string> bodies = {}, FieldBase base = {});

  /// Writes one file and renews the list. Throws RunError that names the file where it cannot be written.
  void write(const FieldSnapshot& snapshot);

  /// When several ranks have each written their piece (piece_name) in its place: lists them in BASE_0000.pvtu. any: a
  /// piece; ranks: that have written one.
  void list_pieces(const FieldPiece& any, const std::vector<std::int32_t>& ranks);
  /// Of the file that comes next.
  std::int64_t next_number() const { return static_cast<std::int64_t>(next_number_); }
  const std::string& folder() const { return folder_; }

  /// Number of files written.
  std::size_t count() const { return written_.size(); }
  const Written& written() const { return written_; }
  /// Names of those that were to be kept and are not there.
  const std::vector<std::string>& lost() const { return lost_; }

 private:
  void write_list() const;

  std::string folder_, base_name_;
  std::vector<std::string> fields_;
  std::string units_;
  std::vector<std::string> bodies_;
  FieldBase base_;
  Written written_;
  std::vector<std::string> lost_;
  std::size_t next_number_ = 0;
};

/// Writes one snapshot with all its fields as `path` (a .vtu file). Throws RunError that names the file.
void write_vtu(const std::string& path, const FieldSnapshot& snapshot, const std::vector<std::string>& fields = {},
               const std::string& units = {}, const std::vector<std::string>& bodies = {}, const FieldBase& base = {});

/// Writes FOLDER/last_good.vtu, a picture of the last state before a run failed, and returns its path. Throws RunError.
std::string write_last_good_state(const std::string& folder, const FieldSnapshot& snapshot,
                                  const std::string& units = {}, const std::vector<std::string>& bodies = {},
                                  const FieldBase& base = {});

}  // namespace pinball
