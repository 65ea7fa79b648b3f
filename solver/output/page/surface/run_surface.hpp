#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <solver/base/point.hpp>

#include "field_frame.hpp"
#include "outer_faces.hpp"

namespace pinball {

/// The output times of a run, each with its fields.
struct FrameSource {
  std::vector<double> times;  ///< [time]
  std::function<FieldFrame(std::size_t)> frame;
};

/// Those of FOLDER/fields.pvd; none where that is not there.
FrameSource frames_of_folder(const std::string& folder);
/// Of a run that has written no fields its last state, and before it the first, as far as that is known: its positions.
/// Refers to both.
FrameSource frames_of_last_state(const FieldSnapshot& last, const FieldBase& base);

/// A node or an element.
struct SurfacePlace {
  std::int64_t place = 0;    ///< in the order of the scene
  std::int64_t number = -1;  ///< in its mesh file; -1: from no file, or files have none
  std::int64_t body = 0;     ///< of a node that several bodies share, the first
};

/// One number for each node or element: a scalar, or the magnitude of a vector.
struct SurfaceField {
  std::string name;
  bool of_nodes = false;
  double least = 0, most = 0;              ///< of all that is not eroded, also inside, and of zero
  std::vector<std::vector<float>> values;  ///< for each frame; empty: it has none
};

/// What is seen of a run's bodies from outside, at some of its output times.
struct RunSurface {
  std::size_t all_times = 0;     ///< that the run has
  std::vector<double> times;     ///< that are here
  std::vector<OuterFace> faces;  ///< corners and elements are places in the lists below
  std::vector<SurfacePlace> nodes, elements;
  std::vector<std::vector<Point>> positions;  ///< for each frame
  std::vector<SurfaceField> fields;           ///< all that the files have but for components of vectors and stresses
};

/// Evenly spaced ones of `all`, with both ends; all, where these are no more than `most` (>= 1; of one, the last).
std::vector<std::size_t> evenly_spaced(std::size_t all, std::size_t most);

inline constexpr std::size_t most_surface_faces = 1'500'000;

/// At as many times as keep the numbers below `most_bytes`, counted with two bytes each. Throws RunError for files that
/// cannot be read and for more than most_surface_faces, InputError as face_neighbours does.
RunSurface gather_surface(const FrameSource& source, std::size_t most_bytes);

/// Whether a face of a node is there, for each node at one frame.
std::vector<std::uint8_t> nodes_seen(const RunSurface& surface, std::size_t frame);

}  // namespace pinball
