#include "field_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include <solver/base/error.hpp>
#include <solver/scene/schema/field_names.hpp>

#include "field_arrays.hpp"
#include "output_file.hpp"
#include "run_files.hpp"
#include "units_comment.hpp"

namespace pinball {
namespace {

static_assert(std::endian::native == std::endian::little, "the appended data are written as they lie in memory");

}  // namespace

void write_vtu(const std::string& path, const FieldSnapshot& snapshot, const std::vector<std::string>& fields,
               const std::string& units, const std::vector<std::string>& bodies, const FieldBase& base) {
  check_sizes(path, snapshot, base);
  const FieldArrays arrays = list_arrays(snapshot, base, fields, bodies);

  // Offsets count from the byte after "_"; each block is its length (UInt64) and its bytes.
  std::string head = "<?xml version=\"1.0\"?>\n" + units_comment(units);
  std::vector<const DataArray*> blocks;
  std::uint64_t offset = 0;
  const auto section = [&](std::string_view name, std::string_view attributes, const std::vector<DataArray>& list) {
    head += fmt::format("      <{}{}>\n", name, attributes);
    for (const DataArray& array : list) {
      head += fmt::format("        <DataArray {} format=\"appended\" offset=\"{}\"/>\n", array.attributes, offset);
      offset += sizeof(std::uint64_t) + array.bytes;
      blocks.push_back(&array);
    }
    head += fmt::format("      </{}>\n", name);
  };
  head +=
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "  <UnstructuredGrid>\n";
  section("FieldData", "", arrays.field);
  head += fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", snapshot.position.size(),
                      snapshot.hexahedra.size());
  section("PointData", arrays.point_attributes, arrays.point);
  section("CellData", arrays.cell_attributes, arrays.cell);
  section("Points", "", arrays.points);
  section("Cells", "", arrays.cells);
  head += "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";

  OutputFile file(path);
  file.write(head);
  for (const DataArray* block : blocks) {
    file.write(&block->bytes, sizeof block->bytes);
    block->write([&file](const void* data, std::size_t bytes) { file.write(data, bytes); });
  }
  file.write("\n  </AppendedData>\n</VTKFile>\n");
  file.commit();
}

FieldWriter::FieldWriter(std::string folder, std::string base_name, std::vector<std::string> fields, std::string units,
                         const Written& kept, std::vector<std::string> bodies, FieldBase base)
    : folder_(std::move(folder)),
      base_name_(std::move(base_name)),
      fields_(std::move(fields)),
      units_(std::move(units)),
      bodies_(std::move(bodies)),
      base_(std::move(base)) {
  for (const std::string& field : fields_) {
    if (std::find(field_names.begin(), field_names.end(), field) == field_names.end()) {
      throw InputError(
          fmt::format("output.fields: unknown field \"{}\", expected some of {}", field, fmt::join(field_names, ", ")));
    }
  }
  make_folder(folder_);

  // What an earlier, longer run left would be opened together with ours.
  const std::string prefix = base_name_ + "_";
  std::vector<std::filesystem::path> stale = {in_folder(folder_, base_name_ + ".pvd")};
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.empty() ? "." : folder_, error)) {
    const std::string stem = entry.path().stem().string();
    const std::string kind = entry.path().extension().string();
    if ((kind == ".vtu" || kind == ".pvtu") && stem.size() > prefix.size() && stem.starts_with(prefix) &&
        is_field_number(stem.substr(prefix.size()))) {
      stale.push_back(entry.path());
    }
  }
  for (const auto& file : kept) {
    const auto there =
        std::find_if(stale.begin(), stale.end(), [&file](const auto& path) { return path.filename() == file.second; });
    if (there == stale.end()) {
      lost_.push_back(file.second);
      continue;
    }
    stale.erase(there);
    const std::string pieces = std::filesystem::path(file.second).stem().string() + '_';
    std::erase_if(stale, [&pieces](const auto& path) { return path.filename().string().starts_with(pieces); });
    written_.push_back(file);
  }
  next_number_ = kept.size();
  for (const auto& path : stale) std::filesystem::remove(path, error);
  if (!written_.empty()) write_list();
}

void FieldWriter::write(const FieldSnapshot& snapshot) {
  const std::string name = fmt::format("{}_{:04}.vtu", base_name_, next_number_++);
  write_vtu(in_folder(folder_, name), snapshot, fields_, units_, bodies_, base_);
  written_.emplace_back(snapshot.time, name);
  write_list();
}

void FieldWriter::list_pieces(const FieldPiece& any, const std::vector<std::int32_t>& ranks) {
  std::vector<std::string> sources;
  for (const std::int32_t rank : ranks) sources.push_back(piece_name(base_name_, next_number(), rank));
  const std::string name = fmt::format("{}_{:04}.pvtu", base_name_, next_number_++);
  write_list_of_pieces(in_folder(folder_, name), list_arrays(any.snapshot, any.base, fields_, bodies_), units_,
                       sources);
  written_.emplace_back(any.snapshot.time, name);
  write_list();
}

void FieldWriter::write_list() const {
  std::string text = "<?xml version=\"1.0\"?>\n" + units_comment(units_) +
                     "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const auto& [time, name] : written_) {
    text += fmt::format("    <DataSet timestep=\"{:.17g}\" group=\"\" part=\"0\" file=\"{}\"/>\n", time, name);
  }
  text += "  </Collection>\n</VTKFile>\n";
  OutputFile file(in_folder(folder_, base_name_ + ".pvd"));
  file.write(text);
  file.commit();
}

std::string write_last_good_state(const std::string& folder, const FieldSnapshot& snapshot, const std::string& units,
                                  const std::vector<std::string>& bodies, const FieldBase& base) {
  make_folder(folder);
  std::string path = in_folder(folder, last_good_picture_name);
  write_vtu(path, snapshot, {}, units, bodies, base);
  return path;
}

}  // namespace pinball
