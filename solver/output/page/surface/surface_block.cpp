#include "surface_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "packing.hpp"

namespace pinball {
namespace {

/// Before they are compressed, beyond which times are left out at once.
constexpr std::size_t most_bytes_gathered = 60'000'000;
constexpr double highest_position = 65000;

/// Where values begin, and how far codes are apart.
struct Scale {
  double low = 0, step = 1;
};

/// What has a sign is shown to both sides of zero, as `pinball view` does.
bool has_sign(const SurfaceField& field) { return field.name == "pressure"; }

std::pair<double, double> range_of(const SurfaceField& field) {
  const double largest = std::max(-field.least, field.most);
  if (has_sign(field)) return {largest > 0 ? -largest : -1, largest > 0 ? largest : 1};
  return {field.least, field.most > field.least ? field.most : field.least + 1};
}

Scale scale_of(const SurfaceField& field) {
  const auto [low, high] = range_of(field);
  return {low, (high - low) / highest_code};
}

/// Steps of the positions of each body: the largest extents that it has at any of the frames, in so many parts.
std::vector<Point> position_steps(const RunSurface& surface, const std::vector<std::size_t>& chosen,
                                  const std::vector<std::vector<std::uint8_t>>& seen, std::size_t bodies) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<Point> steps(bodies, Point{});
  for (const std::size_t k : chosen) {
    std::vector<Point> low(bodies, {infinite, infinite, infinite}), high(bodies, {-infinite, -infinite, -infinite});
    for (std::size_t i = 0; i < surface.nodes.size(); ++i) {
      if (seen[k][i] == 0) continue;
      const std::int64_t body = surface.nodes[i].body;
      for (std::size_t c = 0; c < 3; ++c) {
        const double x = surface.positions[k][i][c];
        if (!std::isfinite(x)) continue;
        low[body][c] = std::min(low[body][c], x);
        high[body][c] = std::max(high[body][c], x);
      }
    }
    for (std::size_t b = 0; b < bodies; ++b) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (high[b][c] > low[b][c]) steps[b][c] = std::max(steps[b][c], (high[b][c] - low[b][c]) / highest_position);
      }
    }
  }
  for (Point& step : steps) {
    const double largest = std::max({step[0], step[1], step[2]});
    for (double& s : step) s = s > 0 ? s : largest > 0 ? largest : 1;
  }
  return steps;
}

/// Packs frames one after the other; holds the codes of the one before.
class FramePacker {
 public:
  FramePacker(const RunSurface& surface, std::vector<Point> steps)
      : surface_(surface),
        steps_(std::move(steps)),
        origins_(3 * steps_.size(), 0),
        before_(3 + surface.fields.size()) {}

  void pack(std::string& to, std::size_t frame, const std::vector<std::uint8_t>& seen) {
    pack_positions(to, surface_.positions[frame], seen);
    for (std::size_t f = 0; f < surface_.fields.size(); ++f) {
      const SurfaceField& field = surface_.fields[f];
      const std::size_t count = field.of_nodes ? surface_.nodes.size() : surface_.elements.size();
      next(to, 3 + f, codes_of(field, field.values[frame], count, field.of_nodes ? &seen : nullptr, before_[3 + f]));
    }
  }

 private:
  void next(std::string& to, std::size_t stream, std::vector<std::uint16_t> codes) {
    pack_codes(to, codes, before_[stream]);
    before_[stream] = std::move(codes);
  }

  std::int64_t steps_to(const Point& position, std::size_t node, std::size_t axis) const {
    const double steps = std::round(position[axis] / steps_[surface_.nodes[node].body][axis]);
    return std::isfinite(steps) && std::abs(steps) < 1e13 ? static_cast<std::int64_t>(steps) : 0;
  }

  /// Nodes that are not seen stay where they are beside their body: what becomes of them takes no room.
  void pack_positions(std::string& to, const std::vector<Point>& positions, const std::vector<std::uint8_t>& seen) {
    constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
    std::vector<std::int64_t> origins(origins_.size(), none);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (seen[i] == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        std::int64_t& origin = origins[3 * surface_.nodes[i].body + c];
        origin = std::min(origin, steps_to(positions[i], i, c));
      }
    }
    for (std::size_t i = 0; i < origins.size(); ++i) {
      if (origins[i] == none) origins[i] = origins_[i];
    }
    pack_integers(to, origins);
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<std::uint16_t> codes = before_[c];
      codes.resize(positions.size(), 0);
      for (std::size_t i = 0; i < positions.size(); ++i) {
        if (seen[i] == 0) continue;
        const std::int64_t code = steps_to(positions[i], i, c) - origins[3 * surface_.nodes[i].body + c];
        codes[i] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(code, 0, 0xffff));
      }
      next(to, c, std::move(codes));
    }
    origins_ = std::move(origins);
  }

  static std::vector<std::uint16_t> codes_of(const SurfaceField& field, const std::vector<float>& values,
                                             std::size_t count, const std::vector<std::uint8_t>* seen,
                                             const std::vector<std::uint16_t>& before) {
    const Scale scale = scale_of(field);
    std::vector<std::uint16_t> codes(count, no_value_code);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (seen != nullptr && (*seen)[i] == 0 && !before.empty()) {
        codes[i] = before[i];
      } else if (std::isfinite(values[i])) {
        const double code = std::round((values[i] - scale.low) / scale.step);
        codes[i] = static_cast<std::uint16_t>(std::clamp(code, 0.0, static_cast<double>(highest_code)));
      }
    }
    return codes;
  }

  const RunSurface& surface_;
  std::vector<Point> steps_;
  std::vector<std::int64_t> origins_;
  std::vector<std::vector<std::uint16_t>> before_;
};

template <class List, class Value>
void pack_list(std::string& to, const List& list, const Value& value) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(list.size());
  for (const auto& one : list) numbers.push_back(value(one));
  pack_integers(to, numbers);
}

/// Frames are counted among those chosen: `from` and `until` become numbers of these.
std::string packed_faces(const RunSurface& surface, const std::vector<std::size_t>& chosen) {
  std::string bytes;
  const auto among_chosen = [&](std::int32_t frame) {
    return std::ranges::lower_bound(chosen, static_cast<std::size_t>(frame)) - chosen.begin();
  };
  for (std::size_t k = 0; k < 4; ++k) pack_list(bytes, surface.faces, [k](const OuterFace& f) { return f.corners[k]; });
  pack_list(bytes, surface.faces, [](const OuterFace& f) { return f.element; });
  pack_list(bytes, surface.faces, [&](const OuterFace& f) { return among_chosen(f.from); });
  pack_list(bytes, surface.faces, [&](const OuterFace& f) { return among_chosen(f.until); });
  for (const std::vector<SurfacePlace>* places : {&surface.nodes, &surface.elements}) {
    pack_list(bytes, *places, [](const SurfacePlace& p) { return p.place; });
    pack_list(bytes, *places, [](const SurfacePlace& p) { return p.number; });
    pack_list(bytes, *places, [](const SurfacePlace& p) { return p.body; });
  }
  return bytes;
}

/// JSON of a text, or of a list of texts.
template <class Text>
std::string json_text(const Text& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

/// All but its last brace: written by hand, because templates for JSON take longer to compile than all else here.
std::string head_of_surface(const RunSurface& surface, const std::vector<std::string>& bodies,
                            const std::vector<std::size_t>& chosen, const std::vector<Point>& steps) {
  std::string times, fields, all_steps;
  for (const std::size_t k : chosen) times += fmt::format("{}{}", times.empty() ? "" : ",", surface.times[k]);
  for (const Point& s : steps) all_steps += fmt::format("{}[{},{},{}]", all_steps.empty() ? "" : ",", s[0], s[1], s[2]);
  for (const SurfaceField& field : surface.fields) {
    const Scale scale = scale_of(field);
    const auto [low, high] = range_of(field);
    fields += fmt::format(R"({}{{"name":{},"of":"{}","signed":{},"low":{},"step":{},"range":[{},{}],"zero":{}}})",
                          fields.empty() ? "" : ",", json_text(field.name), field.of_nodes ? "nodes" : "elements",
                          has_sign(field), scale.low, scale.step, low, high, field.least == 0 && field.most == 0);
  }
  return fmt::format(
      R"({{"times":[{}],"all_times":{},"bodies":{},"steps":[{}],"fields":[{}],"faces":{},"nodes":{},"elements":{},"encoding":"{}")",
      times, surface.all_times, json_text(bodies), all_steps, fields, surface.faces.size(), surface.nodes.size(),
      surface.elements.size(), can_deflate() ? "deflate" : "none");
}

/// At some of the frames.
std::string block_of(const RunSurface& surface, const std::vector<std::string>& bodies,
                     const std::vector<std::vector<std::uint8_t>>& seen, const std::vector<std::size_t>& chosen) {
  const std::vector<Point> steps = position_steps(surface, chosen, seen, bodies.size());
  std::string bytes = packed_faces(surface, chosen);
  FramePacker packer(surface, steps);
  for (const std::size_t k : chosen) packer.pack(bytes, k, seen[k]);
  return head_of_surface(surface, bodies, chosen, steps) + ",\"data\":\"" + base64(deflated(bytes)) + "\"}";
}

}  // namespace

std::string surface_json(const RunSurface& surface, const std::vector<std::string>& bodies, std::size_t most) {
  std::vector<std::vector<std::uint8_t>> seen;
  for (std::size_t k = 0; k < surface.times.size(); ++k) seen.push_back(nodes_seen(surface, k));
  std::size_t frames = surface.times.size();
  for (;;) {
    std::string text = block_of(surface, bodies, seen, evenly_spaced(surface.times.size(), frames));
    if (text.size() <= most) return text;
    if (frames <= 1) return "null";
    const double share = static_cast<double>(most) / static_cast<double>(text.size());
    frames = std::max<std::size_t>(1, std::min(frames - 1, static_cast<std::size_t>(0.97 * share * frames)));
  }
}

std::string surface_json_of_frames(const FrameSource& source, const std::vector<std::string>& bodies) {
  std::string why;
  try {
    const RunSurface surface = gather_surface(source, most_bytes_gathered);
    std::string text = surface_json(surface, bodies);
    if (text != "null") return text;
    why = fmt::format("a surface of {} faces is too large for a page", surface.faces.size());
  } catch (const std::exception& thrown) {
    why = thrown.what();
  }
  return "{\"error\":" + json_text(why) + '}';
}

std::string surface_json_of_run(const std::string& folder, const std::vector<std::string>& bodies,
                                const FieldSnapshot* last, const FieldBase* base) {
  FrameSource source = frames_of_folder(folder);
  if (source.times.empty() && last != nullptr && base != nullptr) source = frames_of_last_state(*last, *base);
  return source.times.empty() ? "null" : surface_json_of_frames(source, bodies);
}

}  // namespace pinball
