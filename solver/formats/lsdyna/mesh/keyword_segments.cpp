#include "keyword_segments.hpp"

#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/base/face_corners.hpp>
#include <solver/base/faces.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/scan/keyword_scanner.hpp>

#include "keyword_boxes.hpp"

namespace pinball {

namespace {

using Face = std::array<std::int32_t, 4>;

/// A face of the surface, and the part that it is of.
struct SurfaceFace {
  Face nodes;
  std::int32_t part;
};

class Segments {
 public:
  Segments(const KeywordDeck& deck, const NumberIndex& nodes, MeshFile& file)
      : deck_(deck), nodes_(nodes), file_(file), boxes_(deck) {}

  void read(const KeywordBlock& block) {
    Cards cards(block);
    FaceSet set;
    read_set_head(block, deck_.parameters, cards, set);
    try {
      add_faces(block, cards, set.faces);
    } catch (const InputError& error) {
      set.problem = error.what();
    }
    const bool collects = block.name.ends_with("_COLLECT");
    if (!collects) given_.add(fmt::format("set of segments {}", set.id), block.place, block.of_case);
    if (!collects && block.of_case)
      std::erase_if(file_.face_sets, [&](const FaceSet& other) { return other.id == set.id; });
    const auto same = std::ranges::find(file_.face_sets, set.id, &FaceSet::id);
    if (collects && same != file_.face_sets.end()) {
      same->faces.insert(same->faces.end(), set.faces.begin(), set.faces.end());
      if (same->problem.empty()) same->problem = set.problem;
    } else {
      file_.face_sets.push_back(std::move(set));
    }
  }

 private:
  void add_faces(const KeywordBlock& block, Cards& cards, std::vector<Face>& faces) {
    std::string form = block.name;
    take_ending(form, "_COLLECT");
    form.erase(0, std::string_view("SET_SEGMENT").size());
    if (form != "" && form != "_GENERAL") fail_at(block.place, block.star_name() + " is not read");
    while (const auto card = cards.next_filled()) {
      const Fields fields(*card, deck_.parameters, form.empty() ? layout::segment : layout::set_general);
      if (form.empty()) {
        faces.push_back(segment(block, fields, 0));
      } else {
        add_general(block, fields, faces);
      }
    }
  }

  /// Corners from a field on; of a triangle the fourth is missing, or the third once more.
  Face segment(const KeywordBlock& block, const Fields& fields, std::size_t first) const {
    Face face{};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::int64_t number = fields.integer(first + i);
      if (number == 0 && i == 3) {
        face[3] = face[2];
        continue;
      }
      const std::int64_t id = number + offset_of(block, &DeckTransform::node);
      face[i] = nodes_.find(id);
      if (face[i] < 0) fail_at(fields.place(), fmt::format("{}: node {} is not there", block.star_name(), id));
    }
    return face;
  }

  /// A line "OPTION number number ..."; with a D before it the option takes away.
  void add_general(const KeywordBlock& block, const Fields& fields, std::vector<Face>& faces) {
    const std::string option = upper_case(fields.text("OPTION"));
    const bool removes = option.starts_with('D');
    const std::vector<Face> some = faces_of(block, removes ? option.substr(1) : option, removes, fields);
    if (!removes) {
      faces.insert(faces.end(), some.begin(), some.end());
      return;
    }
    std::vector<Face> taken;
    for (const Face& face : some) taken.push_back(face_key(face));
    std::sort(taken.begin(), taken.end());
    std::erase_if(faces, [&](const Face& f) { return std::binary_search(taken.begin(), taken.end(), face_key(f)); });
  }

  /// Of PART and BOX the last four are attributes of the segments, but where these are taken away.
  std::vector<Face> faces_of(const KeywordBlock& block, const std::string& option, bool removes, const Fields& fields) {
    if (option == "SEG") return {segment(block, fields, 1)};
    if (option == "ALL") return of_surface([](const SurfaceFace&) { return true; });
    if (option != "PART" && option != "BOX")
      fail_at(fields.place(), fmt::format("{}: option {} is not read", block.star_name(), fields.text("OPTION")));
    std::vector<Face> faces;
    for (std::size_t i = 1; i < (removes ? 8U : 4U); ++i) {
      const std::int64_t number = fields.integer(i);
      if (number == 0) continue;
      const auto more = option == "PART" ? of_part(block, number, fields) : in_box(block, number, fields);
      faces.insert(faces.end(), more.begin(), more.end());
    }
    std::vector<std::string_view> attributes;
    for (std::size_t i = 4; i < 8 && !removes; ++i) {
      if (!fields.blank(i) && fields.text(i) != "0") attributes.push_back(fields.name(i));
    }
    if (!attributes.empty())
      file_.notes.push_back(fmt::format("not used: {}: {} of {} ({}): attributes of segments", block.star_name(),
                                        fmt::join(attributes, ", "), option, fields.place().text()));
    return faces;
  }

  std::vector<Face> of_part(const KeywordBlock& block, std::int64_t number, const Fields& fields) {
    const std::int64_t id = number + offset_of(block, &DeckTransform::part);
    const auto found = std::ranges::find(file_.parts, id, &MeshPart::id);
    if (found == file_.parts.end())
      fail_at(fields.place(), fmt::format("{}: no part has the number {}", block.star_name(), id));
    const auto part = static_cast<std::int32_t>(found - file_.parts.begin());
    return of_surface([part](const SurfaceFace& face) { return face.part == part; });
  }

  std::vector<Face> in_box(const KeywordBlock& block, std::int64_t number, const Fields& fields) {
    const KeywordBox& box = boxes_.find(block, number, fields.place());
    return of_surface([&](const SurfaceFace& face) {
      return std::ranges::all_of(face.nodes, [&](std::int32_t n) { return box.holds(file_.mesh.nodes[n]); });
    });
  }

  template <class Takes>
  std::vector<Face> of_surface(const Takes& takes) {
    if (surface_.empty()) find_surface();
    std::vector<Face> faces;
    for (const SurfaceFace& face : surface_) {
      if (takes(face)) faces.push_back(face.nodes);
    }
    return faces;
  }

  void find_surface() {
    const auto neighbours = face_neighbours(file_.mesh.hexahedra);
    for (std::size_t e = 0; e < neighbours.size(); ++e) {
      for (std::size_t f = 0; f < 6; ++f) {
        if (neighbours[e][f] != -1) continue;
        surface_.push_back({face_of(file_.mesh.hexahedra[e], f), file_.part[e]});
      }
    }
  }

  const KeywordDeck& deck_;
  const NumberIndex& nodes_;
  MeshFile& file_;
  KeywordBoxes boxes_;
  GivenOnce given_;
  std::vector<SurfaceFace> surface_;
};

}  // namespace

void read_keyword_segments(const KeywordDeck& deck, const NumberIndex& nodes, MeshFile& file) {
  Segments segments(deck, nodes, file);
  for (const KeywordBlock& block : deck.blocks) {
    if (block.name.starts_with("SET_SEGMENT")) segments.read(block);
  }
}

}  // namespace pinball
