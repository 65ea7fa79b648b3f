#include "run_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/output/run_files.hpp>

namespace pinball {
namespace {

using Corners = std::array<std::int32_t, 8>;

std::vector<Corners> elements_of(const FieldFrame& frame) {
  const std::vector<std::int32_t> corners = frame.read<std::int32_t>("connectivity");
  std::vector<Corners> elements;
  std::size_t begin = 0;
  for (const std::int64_t end : frame.read<std::int64_t>("offsets")) {
    elements.push_back(corners_of_cell(std::span(corners).subspan(begin, end - begin)));
    begin = end;
  }
  return elements;
}

/// Of each element the number of the first of the chosen frames in which it is eroded, or of all of them.
std::vector<std::int32_t> ends_of(const FrameSource& source, const std::vector<std::size_t>& chosen,
                                  std::size_t elements) {
  const auto frames = static_cast<std::int32_t>(chosen.size());
  std::vector<std::int32_t> ends(elements, frames);
  for (std::int32_t k = 0; k < frames; ++k) {
    const std::vector<std::uint8_t> alive = source.frame(chosen[k]).read<std::uint8_t>("alive");
    if (alive.size() != elements) throw RunError("cannot read the fields: output times have different meshes");
    for (std::size_t e = 0; e < elements; ++e) {
      if (alive[e] == 0) ends[e] = std::min(ends[e], k);
    }
  }
  return ends;
}

/// Fields that one number of each node or element shows.
std::vector<SurfaceField> fields_of(const FieldFrame& frame) {
  std::vector<SurfaceField> fields;
  for (const FieldFrame::Array& array : frame.arrays()) {
    const bool of_nodes = array.section == "PointData", of_elements = array.section == "CellData";
    const bool one = array.components == 1 || (of_nodes && array.components == 3);
    if (array.type == "Float32" && one && (of_nodes || of_elements)) fields.push_back({array.name, of_nodes, 0, 0, {}});
  }
  return fields;
}

std::vector<std::int64_t> numbers_of(const FieldFrame& frame, const char* name, std::size_t count) {
  return frame.has(name) ? frame.read<std::int64_t>(name) : std::vector<std::int64_t>(count, -1);
}

/// Leaves in the faces places in the lists of nodes and elements, which have those of the faces.
void number_places(RunSurface& surface, const FieldFrame& frame, const std::vector<Corners>& elements,
                   const std::vector<std::int32_t>& body, std::size_t nodes) {
  std::vector<std::int32_t> body_of_node(nodes, -1), place_of_node(nodes, -1), place_of_element(elements.size(), -1);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (const std::int32_t node : elements[e]) {
      if (body_of_node[node] < 0) body_of_node[node] = body[e];
    }
  }
  for (const OuterFace& face : surface.faces) {
    for (const std::int32_t node : face.corners) place_of_node[node] = 0;
    place_of_element[face.element] = 0;
  }
  const auto list = [](std::vector<std::int32_t>& places, const std::vector<std::int64_t>& numbers,
                       const std::vector<std::int32_t>& bodies, std::vector<SurfacePlace>& to) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i] < 0) continue;
      places[i] = static_cast<std::int32_t>(to.size());
      to.push_back({static_cast<std::int64_t>(i), numbers[i], bodies[i]});
    }
  };
  list(place_of_node, numbers_of(frame, "node_number", nodes), body_of_node, surface.nodes);
  list(place_of_element, numbers_of(frame, "element_number", elements.size()), body, surface.elements);
  for (OuterFace& face : surface.faces) {
    for (std::int32_t& node : face.corners) node = place_of_node[node];
    face.element = place_of_element[face.element];
  }
}

/// Magnitudes of vectors, in double as readers of the files make them.
std::vector<float> magnitudes(const std::vector<float>& numbers, std::size_t components) {
  if (components == 1) return numbers;
  std::vector<float> sizes(numbers.size() / 3);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double x = numbers[3 * i], y = numbers[3 * i + 1], z = numbers[3 * i + 2];
    sizes[i] = static_cast<float>(std::sqrt(x * x + y * y + z * z));
  }
  return sizes;
}

std::vector<float> values_at(const std::vector<float>& all, const std::vector<SurfacePlace>& places) {
  std::vector<float> some(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) some[i] = all[places[i].place];
  return some;
}

void take_range(SurfaceField& field, const std::vector<float>& all, const std::vector<std::uint8_t>& counts) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (counts[i] == 0 || !std::isfinite(all[i])) continue;
    field.least = std::min<double>(field.least, all[i]);
    field.most = std::max<double>(field.most, all[i]);
  }
}

void take_frame(RunSurface& surface, const FieldFrame& frame, const std::vector<Corners>& elements,
                const std::vector<std::uint8_t>& alive) {
  const std::vector<double> points = frame.read<double>("Points");
  std::vector<std::uint8_t> held(points.size() / 3, 0);  // nodes by elements that are there
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (alive[e] == 0) continue;
    for (const std::int32_t node : elements[e]) held[node] = 1;
  }
  std::vector<Point>& positions = surface.positions.emplace_back(surface.nodes.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    std::copy_n(points.begin() + 3 * surface.nodes[i].place, 3, positions[i].begin());
  }
  for (SurfaceField& field : surface.fields) {
    std::vector<float>& values = field.values.emplace_back();
    const auto array = std::ranges::find(frame.arrays(), field.name, &FieldFrame::Array::name);
    if (array == frame.arrays().end()) continue;
    const std::vector<float> all = magnitudes(frame.read<float>(field.name), array->components);
    take_range(field, all, field.of_nodes ? held : alive);
    values = values_at(all, field.of_nodes ? surface.nodes : surface.elements);
  }
}

/// Two bytes for each number of a frame.
std::size_t bytes_of_frame(std::size_t faces, const std::vector<SurfaceField>& fields) {
  return faces * 2 * (3 + fields.size());  // there are about as many nodes, and fewer elements
}

}  // namespace

FrameSource frames_of_folder(const std::string& folder) {
  FrameSource source;
  std::vector<std::string> files;
  std::ifstream list(in_folder(folder, std::string(fields_base) + ".pvd"), std::ios::binary);
  for (std::string line; std::getline(list, line);) {
    if (line.find("<DataSet ") == std::string::npos) continue;
    source.times.push_back(std::strtod(std::string(xml_attribute(line, "timestep")).c_str(), nullptr));
    files.push_back(in_folder(folder, xml_attribute(line, "file")));
  }
  source.frame = [files = std::move(files)](std::size_t i) { return FieldFrame::of_file(files[i]); };
  return source;
}

FrameSource frames_of_last_state(const FieldSnapshot& last, const FieldBase& base) {
  FrameSource source;
  if (!base.initial.empty() && last.time > 0) {
    auto first = std::make_shared<FieldSnapshot>();
    first->position.assign(base.initial.begin(), base.initial.end());
    first->hexahedra = last.hexahedra;
    first->body = last.body;
    source.times.push_back(0);
    source.frame = [first, &last, &base](std::size_t i) {
      return FieldFrame::of_snapshot(i == 0 ? *first : last, base);
    };
  } else {
    source.frame = [&last, &base](std::size_t) { return FieldFrame::of_snapshot(last, base); };
  }
  source.times.push_back(last.time);
  return source;
}

std::vector<std::size_t> evenly_spaced(std::size_t all, std::size_t most) {
  const std::size_t count = std::min(all, most);
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < count; ++k) {
    chosen.push_back(count == 1 ? all - 1 : (k * (all - 1) + (count - 1) / 2) / (count - 1));
  }
  return chosen;
}

RunSurface gather_surface(const FrameSource& source, std::size_t most_bytes) {
  RunSurface surface;
  surface.all_times = source.times.size();
  const FieldFrame first = source.frame(0), last = source.frame(source.times.size() - 1);
  const std::vector<Corners> elements = elements_of(first);
  const std::vector<std::int32_t> body = first.read<std::int32_t>("body");
  surface.fields = fields_of(last);

  std::vector<std::size_t> chosen = evenly_spaced(source.times.size(), 2);
  std::vector<std::int32_t> ends = ends_of(source, chosen, elements.size());
  surface.faces = outer_faces(elements, body, ends);
  if (surface.faces.size() > most_surface_faces) {
    throw RunError(fmt::format("a surface of {} faces is too large for a page", surface.faces.size()));
  }
  const std::size_t bytes = std::max<std::size_t>(1, bytes_of_frame(surface.faces.size(), surface.fields));
  if (source.times.size() > 2) {
    chosen = evenly_spaced(source.times.size(), std::max<std::size_t>(2, most_bytes / bytes));
    ends = ends_of(source, chosen, elements.size());
    surface.faces = outer_faces(elements, body, ends);
  }
  number_places(surface, first, elements, body, first.read<double>("Points").size() / 3);
  for (const std::size_t k : chosen) {
    const FieldFrame frame = source.frame(k);
    surface.times.push_back(source.times[k]);
    take_frame(surface, frame, elements, frame.read<std::uint8_t>("alive"));
  }
  return surface;
}

std::vector<std::uint8_t> nodes_seen(const RunSurface& surface, std::size_t frame) {
  std::vector<std::uint8_t> seen(surface.nodes.size(), 0);
  const auto k = static_cast<std::int32_t>(frame);
  for (const OuterFace& face : surface.faces) {
    if (k < face.from || k >= face.until) continue;
    for (const std::int32_t node : face.corners) seen[node] = 1;
  }
  return seen;
}

}  // namespace pinball
