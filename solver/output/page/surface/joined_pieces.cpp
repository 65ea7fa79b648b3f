#include <algorithm>
#include <cstring>
#include <fstream>
#include <memory>

#include <solver/base/error.hpp>
#include <solver/output/field_arrays.hpp>
#include <solver/output/run_files.hpp>

#include "field_frame.hpp"

/// The pieces of one output time that several ranks have written, as one mesh in the order of the scene.
namespace pinball {
namespace {

[[noreturn]] void throw_apart(const std::string& name) {
  throw RunError("cannot read the field " + name + ": pieces do not belong together");
}

/// Behind the largest of these places.
std::int64_t count_of(const std::vector<std::int64_t>& places) {
  std::int64_t count = 0;
  for (const std::int64_t place : places) {
    if (place < 0) throw_apart(std::string(node_places));
    count = std::max(count, place + 1);
  }
  return count;
}

/// Pieces, and where what each has is among all.
struct JoinedPieces {
  std::vector<FieldFrame> pieces;
  std::vector<std::vector<std::int64_t>> nodes, elements;
  std::int64_t node_count = 0, element_count = 0;

  void add(FieldFrame piece) {
    nodes.push_back(piece.read<std::int64_t>(node_places));
    elements.push_back(piece.read<std::int64_t>(element_places));
    node_count = std::max(node_count, count_of(nodes.back()));
    element_count = std::max(element_count, count_of(elements.back()));
    pieces.push_back(std::move(piece));
  }
};

std::vector<char> bytes_of(const FieldFrame& piece, const std::string& name) {
  const auto array = std::ranges::find(piece.arrays(), name, &FieldFrame::Array::name);
  if (array == piece.arrays().end()) throw_apart(name);
  std::vector<char> bytes(array->bytes);
  array->read(bytes.data());
  return bytes;
}

/// As many bytes for each node or element.
FieldFrame::Array joined_numbers(const std::shared_ptr<const JoinedPieces>& all, const FieldFrame::Array& of_first) {
  const bool of_nodes = of_first.section == "PointData" || of_first.section == "Points";
  const auto& places = of_nodes ? all->nodes : all->elements;
  const std::size_t width = of_first.bytes / std::max<std::size_t>(1, places.front().size());
  FieldFrame::Array array = of_first;
  array.bytes = width * static_cast<std::uint64_t>(of_nodes ? all->node_count : all->element_count);
  array.read = [all, width, of_nodes, name = of_first.name](char* to) {
    for (std::size_t p = 0; p < all->pieces.size(); ++p) {
      const std::vector<std::int64_t>& own = of_nodes ? all->nodes[p] : all->elements[p];
      const std::vector<char> bytes = bytes_of(all->pieces[p], name);
      if (bytes.size() != width * own.size()) throw_apart(name);
      for (std::size_t i = 0; i < own.size(); ++i) std::memcpy(to + width * own[i], bytes.data() + width * i, width);
    }
  };
  return array;
}

/// Ends of the corners of all elements.
std::vector<std::int64_t> ends_of(const JoinedPieces& all) {
  std::vector<std::int64_t> ends(all.element_count, 0);
  for (std::size_t p = 0; p < all.pieces.size(); ++p) {
    const std::vector<std::int64_t> own = all.pieces[p].read<std::int64_t>("offsets");
    for (std::size_t e = 0; e < own.size(); ++e) ends[all.elements[p][e]] = own[e] - (e == 0 ? 0 : own[e - 1]);
  }
  for (std::size_t e = 1; e < ends.size(); ++e) ends[e] += ends[e - 1];
  return ends;
}

void read_corners(const JoinedPieces& all, char* to) {
  const std::vector<std::int64_t> ends = ends_of(all);
  for (std::size_t p = 0; p < all.pieces.size(); ++p) {
    const std::vector<std::int32_t> corners = all.pieces[p].read<std::int32_t>("connectivity");
    const std::vector<std::int64_t> own = all.pieces[p].read<std::int64_t>("offsets");
    std::int64_t corner = 0;
    for (std::size_t e = 0; e < own.size(); ++e) {
      std::int64_t at = ends[all.elements[p][e]] - (own[e] - corner);
      for (; corner < own[e]; ++corner, ++at) {
        const auto node = static_cast<std::int32_t>(all.nodes[p][corners[corner]]);
        std::memcpy(to + at * static_cast<std::int64_t>(sizeof node), &node, sizeof node);
      }
    }
  }
}

}  // namespace

FieldFrame FieldFrame::of_pieces(const std::string& path) {
  const auto all = std::make_shared<JoinedPieces>();
  const std::string folder = std::filesystem::path(path).parent_path().string();
  std::ifstream list(path, std::ios::binary);
  for (std::string line; std::getline(list, line);) {
    if (line.find("<Piece ") == std::string::npos) continue;
    all->add(of_one_file(in_folder(folder, xml_attribute(line, "Source"))));
  }
  if (all->pieces.empty()) throw RunError("cannot read " + path + ": expected pieces of field output");
  FieldFrame frame;
  for (const Array& of_first : all->pieces.front().arrays_) {
    if (of_first.name == node_places || of_first.name == element_places) continue;
    if (of_first.section == "FieldData") {
      frame.arrays_.push_back(of_first);
    } else if (of_first.name == "offsets") {
      Array& array = frame.arrays_.emplace_back(of_first);
      array.bytes = static_cast<std::uint64_t>(all->element_count) * sizeof(std::int64_t);
      array.read = [all](char* to) {
        const std::vector<std::int64_t> ends = ends_of(*all);
        std::memcpy(to, ends.data(), ends.size() * sizeof(std::int64_t));
      };
    } else if (of_first.name == "connectivity") {
      Array& array = frame.arrays_.emplace_back(of_first);
      array.bytes = 0;
      for (const FieldFrame& piece : all->pieces) array.bytes += piece.find("connectivity")->bytes;
      array.read = [all](char* to) { read_corners(*all, to); };
    } else {
      frame.arrays_.push_back(joined_numbers(all, of_first));
    }
  }
  return frame;
}

}  // namespace pinball
