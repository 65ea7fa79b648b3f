#include "radioss_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/base/face_corners.hpp>
#include <solver/base/faces.hpp>
#include <solver/formats/deck/missed_last.hpp>

#include "radioss_members.hpp"

namespace pinball {

namespace {

void sort_and_keep_one_of_each(std::vector<std::int32_t>& places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

template <class Items>
void add_all(Items& all, const Items& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// "PART" of "GRNOD/PART" or "SURF/PART/EXT".
std::string kind_of(const RadiossBlock& block) {
  const std::size_t first = block.name.find('/') + 1;
  return block.name.substr(first, block.name.find('/', first) - first);
}

/// A box along the axes, its faces included.
struct RadiossBox {
  Point low{}, high{};

  explicit RadiossBox(const RadiossBlock& block) {
    RadiossLines lines(block);
    const DataLine system = lines.require("the system of the box"), first = lines.require("a corner of the box"),
                   second = lines.require("a corner of the box");
    const RadiossFields s(system, block, radioss::box_system), a(first, block, radioss::box_low),
        b(second, block, radioss::box_high);
    const Point p = a.point("Xp1"), q = b.point("Xp2");
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(p[k], q[k]);
      high[k] = std::max(p[k], q[k]);
    }
  }
  bool holds(const Point& x) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (x[k] < low[k] || x[k] > high[k]) return false;
    }
    return true;
  }
};

}  // namespace

RadiossGroups::RadiossGroups(const RadiossDeck& deck, const RadiossParts& parts, MeshFile& file,
                             const NumberIndex& nodes, const std::vector<RigidShell>& shells)
    : deck_(deck),
      parts_(parts),
      file_(file),
      middles_(file),
      nodes_(nodes),
      shells_(shells),
      bricks_(file.element_ids) {}

void RadiossGroups::name_groups() {
  GivenOnce given;
  const auto take = [&](const RadiossBlock& block, const char* family, const char* what,
                        std::map<std::int64_t, const RadiossBlock*>& groups) {
    if (!block.name.starts_with(family)) return;
    given.add(fmt::format("{} {}", what, block.id()), block.place);
    groups[block.id()] = &block;
  };
  for (const RadiossBlock& block : deck_.blocks) {
    take(block, "GRNOD/", "group of nodes", node_groups_);
    take(block, "GRBRIC/", "group of solids", brick_groups_);
    take(block, "SURF/", "surface", surfaces_);
    take(block, "LINE/", "line", lines_);
    take(block, "BOX/", "box", boxes_);
  }
}

void RadiossGroups::read() {
  name_groups();
  const auto tried = [&](auto& set, auto& members, const auto& find) {
    depth_ = 0;  // also where the one before was wrong
    try {
      members = find();
    } catch (const InputError& error) {
      set.problem = error.what();
    }
  };
  for (const auto& [id, block] : node_groups_) {
    MeshSet set{.id = id, .name = "", .members = {}};
    tried(set, set.members, [&, group = block] { return nodes_of(*group); });
    file_.node_sets.push_back(std::move(set));
  }
  for (const auto& [id, block] : brick_groups_) {
    MeshSet set{.id = id, .name = "", .members = {}};
    tried(set, set.members, [&, group = block] { return bricks_of(*group); });
    file_.element_sets.push_back(std::move(set));
  }
  for (const auto& [id, block] : surfaces_) {
    FaceSet set{.id = id, .name = "", .faces = {}};
    tried(set, set.faces, [&, group = block] { return faces_of(*group); });
    file_.face_sets.push_back(std::move(set));
  }
  for (const auto& [id, block] : lines_) {  // edges of these faces
    FaceSet set{.id = 0, .name = fmt::format("line_{}", id), .faces = {}};
    tried(set, set.faces, [&, group = block] { return faces_of(*group); });
    file_.face_sets.push_back(std::move(set));
  }
}

const RadiossBlock& RadiossGroups::find(const std::map<std::int64_t, const RadiossBlock*>& groups, const char* what,
                                        std::int64_t id, const DeckPlace& place) const {
  const auto found = groups.find(id);
  if (found == groups.end()) fail_at(place, fmt::format("no /{} has the number {}", what, id));
  if (depth_ > deepest_radioss_group) fail_at(found->second->place, fmt::format("/{}: the group is in itself", what));
  return *found->second;
}

RadiossGroups::Places RadiossGroups::nodes_of(const RadiossBlock& block) {
  const std::string kind = kind_of(block);
  Places all;
  ++depth_;
  if (kind == "NODE") {
    all = numbered(block, true);
  } else if (kind == "GENE" || kind == "GEN_INCR") {
    all = in_ranges(block, true, kind == "GEN_INCR");
  } else if (kind == "BOX") {
    all = in_boxes(block, true);
  } else if (kind == "GRNOD" || kind == "GRBRIC" || kind == "SURF") {
    for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
      if (kind == "GRNOD") add_all(all, nodes_of(find(node_groups_, "GRNOD", id, place)));
      if (kind == "GRBRIC") add_all(all, nodes_of_bricks(bricks_of(find(brick_groups_, "GRBRIC", id, place))));
      if (kind == "SURF") add_all(all, nodes_of_surface(find(surfaces_, "SURF", id, place)));
    });
  } else {
    all = nodes_of_bricks(bricks_of_parts(block, kind));
    for (const Face& shell : shells_of_parts(block, kind)) all.insert(all.end(), shell.begin(), shell.end());
  }
  --depth_;
  sort_and_keep_one_of_each(all);
  return all;
}

/// Segments have the nodes that they name; the outside of solids those on its edges, too, and those that it has in
/// common with other solids.
RadiossGroups::Places RadiossGroups::nodes_of_surface(const RadiossBlock& block) {
  const std::string kind = kind_of(block);
  if (kind == "SEG") return nodes_of_faces(faces_of(block));
  Places all;
  if (kind != "SURF") {
    all = middles_.nodes_of(outside_of(bricks_of_surface(block)).all);
    for (const Face& shell : shells_of_surface(block)) all.insert(all.end(), shell.begin(), shell.end());
    return all;
  }
  ++depth_;
  for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
    add_all(all, nodes_of_surface(find(surfaces_, "SURF", id, place)));
  });
  --depth_;
  return all;
}

RadiossGroups::Places RadiossGroups::bricks_of(const RadiossBlock& block) {
  const std::string kind = kind_of(block);
  Places all;
  ++depth_;
  if (kind == "BRIC") {
    all = numbered(block, false);
  } else if (kind == "GENE" || kind == "GEN_INCR") {
    all = in_ranges(block, false, kind == "GEN_INCR");
  } else if (kind == "BOX") {
    all = in_boxes(block, false);
  } else if (kind == "GRBRIC") {
    for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
      add_all(all, bricks_of(find(brick_groups_, "GRBRIC", id, place)));
    });
  } else {
    all = bricks_of_parts(block, kind);
  }
  --depth_;
  sort_and_keep_one_of_each(all);
  return all;
}

std::vector<RadiossGroups::Face> RadiossGroups::faces_of(const RadiossBlock& block) {
  const std::string kind = kind_of(block);
  std::vector<Face> faces;
  ++depth_;
  if (kind == "SEG") {
    RadiossLines lines(block);
    while (const auto line = lines.next_filled())
      faces.push_back(segment(RadiossFields(*line, block, radioss::segment)));
  } else if (kind == "SURF") {
    for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
      add_all(faces, faces_of(find(surfaces_, "SURF", id, place)));
    });
  } else {
    const Outside outside = outside_of(bricks_of_surface(block));
    faces = outside.of_mesh;
    const std::size_t inside = outside.all.size() - faces.size();
    const std::string note = fmt::format("{} ({}): {} that other solids have, too, not in it: nothing touches there",
                                         block.title, block.place.text(), counted(inside, "face", "faces"));
    if (inside > 0 && std::ranges::find(file_.notes, note) == file_.notes.end()) file_.notes.push_back(note);
    add_all(faces, shells_of_surface(block));
  }
  --depth_;
  return faces;
}

RadiossGroups::Places RadiossGroups::numbered(const RadiossBlock& block, bool of_nodes) const {
  Places all;
  for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
    const std::int32_t found = (of_nodes ? nodes_ : bricks_).find(id);
    if (found < 0) fail_at(place, fmt::format("{}: {} {} is not there", block.title, of_nodes ? "node" : "solid", id));
    all.push_back(found);
  });
  return all;
}

/// What is not there in between is left out.
RadiossGroups::Places RadiossGroups::in_ranges(const RadiossBlock& block, bool of_nodes, bool steps) {
  const std::vector<std::int64_t>& numbers = of_nodes ? file_.node_ids : file_.element_ids;
  Places all;
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, steps ? radioss::range_steps : radioss::ranges);
    const std::int64_t first = f.integer("Ifirst"), last = f.integer("Ilast"), step = steps ? f.integer("Iincr") : 1;
    if (step < 1) f.fail("Iincr", fmt::format("expected at least 1, got {}", step));
    const std::size_t before = all.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (numbers[i] >= first && numbers[i] <= last && (numbers[i] - first) % step == 0) all.push_back(i);
    }
    if (all.size() == before) fail_at(line->place, fmt::format("{}: none from {} to {}", block.title, first, last));
    note_missed_last(block.title, line->place, first, last, step, file_.notes);
  }
  return all;
}

/// Nodes in the boxes; elements all of whose nodes are in one of them.
RadiossGroups::Places RadiossGroups::in_boxes(const RadiossBlock& block, bool of_nodes) const {
  Places all;
  for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
    const RadiossBox box(find(boxes_, "BOX", id, place));
    const auto is_inside = [&](std::int32_t node) { return box.holds(file_.mesh.nodes[node]); };
    const std::size_t count = of_nodes ? file_.node_ids.size() : file_.element_ids.size();
    for (std::size_t i = 0; i < count; ++i) {
      Places nodes;
      if (!of_nodes) add_nodes_of_element(file_, i, nodes);
      if (of_nodes ? is_inside(i) : std::ranges::all_of(nodes, is_inside)) all.push_back(i);
    }
  });
  return all;
}

/// Per part of the file.
std::vector<bool> RadiossGroups::parts_of(const RadiossBlock& block, std::string_view kind) const {
  std::vector<std::int64_t> wanted;
  for_each_radioss_member(
      block, [&](std::int64_t id, const DeckPlace& place) { add_all(wanted, parts_.named(kind, id, place)); });
  std::vector<bool> takes(file_.parts.size(), false);
  for (std::size_t p = 0; p < file_.parts.size(); ++p) takes[p] = std::ranges::count(wanted, file_.parts[p].id) > 0;
  return takes;
}

std::vector<RadiossGroups::Face> RadiossGroups::shells_of_parts(const RadiossBlock& block,
                                                                std::string_view kind) const {
  std::vector<Face> faces;
  if (shells_.empty()) return faces;
  const std::vector<bool> takes = parts_of(block, kind);
  for (const RigidShell& shell : shells_) {
    if (takes[shell.part]) faces.push_back(shell.nodes);
  }
  return faces;
}

std::vector<RadiossGroups::Face> RadiossGroups::shells_of_surface(const RadiossBlock& block) const {
  const std::string kind = kind_of(block);
  return kind == "GRBRIC" ? std::vector<Face>{} : shells_of_parts(block, kind);
}

RadiossGroups::Places RadiossGroups::bricks_of_parts(const RadiossBlock& block, std::string_view kind) const {
  const std::vector<bool> takes = parts_of(block, kind);
  Places all;
  for (std::size_t e = 0; e < file_.part.size(); ++e) {
    if (takes[file_.part[e]]) all.push_back(e);
  }
  return all;
}

RadiossGroups::Places RadiossGroups::nodes_of_bricks(const Places& bricks) const {
  Places all;
  for (const std::int32_t e : bricks) add_nodes_of_element(file_, e, all);
  sort_and_keep_one_of_each(all);
  return all;
}

/// Of a triangle the fourth is missing, or the third once more.
RadiossGroups::Face RadiossGroups::segment(const RadiossFields& fields) const {
  const std::size_t first = radioss::segment.find("node_ID1");
  Face face{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t id = fields.integer(first + i);
    if (id == 0 && i == 3) {
      face[3] = face[2];
      continue;
    }
    face[i] = nodes_.find(id);
    if (face[i] < 0) fields.fail(fields.name(first + i), fmt::format("node {} is not there", id));
  }
  return face;
}

/// Of parts, or of a group of solids.
RadiossGroups::Places RadiossGroups::bricks_of_surface(const RadiossBlock& block) {
  const std::string kind = kind_of(block);
  if (kind != "GRBRIC") return bricks_of_parts(block, kind);
  Places all;
  for_each_radioss_member(block, [&](std::int64_t id, const DeckPlace& place) {
    add_all(all, bricks_of(find(brick_groups_, "GRBRIC", id, place)));
  });
  sort_and_keep_one_of_each(all);
  return all;
}

RadiossGroups::Outside RadiossGroups::outside_of(const Places& bricks) {
  if (neighbours_.empty()) neighbours_ = face_neighbours(file_.mesh.hexahedra);
  std::vector<bool> is_in(file_.mesh.hexahedra.size(), false);
  for (const std::int32_t e : bricks) is_in[e] = true;
  Outside outside;
  for (const std::int32_t e : bricks) {
    for (std::size_t f = 0; f < 6; ++f) {
      const std::int32_t other = neighbours_[e][f];
      if (other == -1) outside.of_mesh.push_back(face_of(file_.mesh.hexahedra[e], f));
      if (other == -1 || (other >= 0 && !is_in[other])) outside.all.push_back(face_of(file_.mesh.hexahedra[e], f));
    }
  }
  return outside;
}

}  // namespace pinball
