#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/face_corners.hpp>
#include <solver/base/faces.hpp>
#include <solver/formats/deck/deck_side.hpp>
#include <solver/formats/radioss/layouts/radioss_contact_cards.hpp>

#include "radioss_keys.hpp"
#include "radioss_rules.hpp"

namespace pinball {

namespace {

using Face = std::array<std::int32_t, 4>;

/// One /INTER.
struct RadiossContact {
  std::string name;
  DeckCard card;
  bool tied = false;
  DeckSide first, second;  ///< second: empty: the first touches itself
  double friction = 0;
  double start = 0, end = 0;  ///< end: 0: none
  double tolerance = -1;      ///< of a tie; negative: none is given
};

/// Which bodies a surface is all of, found once.
class WholeSurfaces {
 public:
  explicit WholeSurfaces(const RadiossData& data) : data_(data) {}

  /// The bodies, if the faces are all those on the surface of some bodies; else none.
  std::vector<std::string> bodies_of(const std::vector<Face>& faces) {
    if (of_face_.empty()) find_surfaces();
    std::map<std::int32_t, std::size_t> found;
    std::map<Face, bool> seen;
    for (const Face& face : faces) {
      const Face key = face_key(face);
      const auto part = of_face_.find(key);
      if (part == of_face_.end()) return {};
      if (!seen.emplace(key, true).second) continue;
      ++found[part->second];
    }
    std::vector<bool> parts(data_.mesh.parts.size(), false);
    for (const auto& [part, count] : found) {
      if (count != faces_[part]) return {};
      parts[part] = true;
    }
    return data_.bodies_of(parts);
  }
  /// The same of nodes: all those on the surface of some bodies, or all of these; others of no solid do not count.
  std::vector<std::string> bodies_of_nodes(const MeshSet& group) {
    if (of_face_.empty()) find_surfaces();
    const std::vector<bool> in_group = data_.nodes_in(group);
    std::vector<bool> whole(data_.mesh.parts.size(), true);
    for (const auto& [key, part] : of_face_) {
      for (const std::int32_t node : key) whole[part] = whole[part] && (node < 0 || in_group[node]);
    }
    return data_.are_of_parts(in_group, whole) ? data_.bodies_of(whole) : std::vector<std::string>{};
  }

 private:
  void find_surfaces() {
    faces_.assign(data_.mesh.parts.size(), 0);
    const auto neighbours = face_neighbours(data_.mesh.mesh.hexahedra);
    for (std::size_t e = 0; e < neighbours.size(); ++e) {
      for (std::size_t f = 0; f < 6; ++f) {
        const auto& n = data_.mesh.mesh.hexahedra[e];
        const Face face = face_of(n, f);
        if (neighbours[e][f] != -1 || (is_layer(e) && !is_of_shell(n, face))) continue;
        of_face_[face_key(face)] = data_.mesh.part[e];
        ++faces_[data_.mesh.part[e]];
      }
    }
  }

  /// Surfaces of shells have the faces of their layers that are not on edges.
  bool is_layer(std::size_t e) const { return data_.mesh.parts[data_.mesh.part[e]].shells > 0; }
  static bool is_of_shell(const std::array<std::int32_t, 8>& n, const Face& face) {
    return face_key(face) == face_key({n[0], n[3], n[2], n[1]}) || face_key(face) == face_key({n[4], n[5], n[6], n[7]});
  }

  const RadiossData& data_;
  std::map<Face, std::int32_t> of_face_;  ///< place of the part in the mesh
  std::vector<std::size_t> faces_;        ///< per part: how many are on the surface
};

/// /INTER... of a deck, one after the other.
class ContactReader {
 public:
  explicit ContactReader(RadiossData& data) : data_(data), whole_(data) {}

  RadiossContact read(const RadiossBlock& block) {
    RadiossContact contact;
    contact.name = fmt::format("contact_{}", block.id());
    contact.card = card_of(block, block.place);
    if (block.name == "INTER/TYPE2") read_tie(block, contact);
    if (block.name == "INTER/TYPE7") read_type7(block, contact);
    if (block.name == "INTER/TYPE11") read_type11(block, contact);
    if (block.name == "INTER/TYPE24" || block.name == "INTER/TYPE25") read_type24(block, contact);
    return contact;
  }

 private:
  DeckSide side_of_surface(std::int64_t id, const DeckPlace& place) {
    const FaceSet& surface = data_.surface(id, place);
    const std::vector<std::string> bodies = whole_.bodies_of(surface.faces);
    return bodies.empty() ? DeckSide{{}, "faces", std::to_string(id)} : DeckSide{bodies};
  }
  DeckSide side_of_line(std::int64_t id, const DeckPlace& place) {
    const std::string name = fmt::format("line_{}", id);
    const FaceSet* faces = find_set(data_.mesh.face_sets, name);
    if (faces == nullptr) fail_at(place, fmt::format("no /LINE/SURF has the number {}", id));
    const std::vector<std::string> bodies = whole_.bodies_of(faces->faces);
    return bodies.empty() ? DeckSide{{}, "faces", name} : DeckSide{bodies};
  }
  DeckSide side_of_nodes(std::int64_t id, const DeckPlace& place) {
    const MeshSet& group = data_.node_group(id, place);
    const std::vector<std::string> bodies = whole_.bodies_of_nodes(group);
    return bodies.empty() ? DeckSide{{}, "nodes", std::to_string(id)} : DeckSide{bodies};
  }

  static void read_times(const RadiossFields& f, RadiossContact& contact) {
    contact.friction = f.number("Fric");
    contact.start = f.number("Tstart");
    const double stop = f.number("Tstop");
    contact.end = stop > 0 && stop < 1e19 ? stop : 0;
  }

  /// What more a block has is of options that are refused.
  void read_type7(const RadiossBlock& block, RadiossContact& contact) {
    RadiossLines lines(block);
    const DataLine l1 = lines.require("the nodes and the surface"), l2 = lines.next_or_blank(),
                   l3 = lines.next_or_blank();
    const RadiossFields sides(l1, block, radioss::type7_sides), gap(l2, block, radioss::type7_gap),
        stiffness(l3, block, radioss::type7_stiffness);
    const std::int64_t curvature = sides.integer("Icurv");
    if (curvature != 0)
      data_.report.reject(l1.place, fmt::format("{} with Icurv {}", block.title, curvature),
                          "leave it 0: faces are as flat as their nodes say");
    if (curvature == 1 || curvature == 2) lines.next();  // the nodes that it is given by
    const DataLine l4 = lines.next_or_blank(), l5 = lines.next_or_blank(), l6 = lines.next_or_blank();
    const RadiossFields scales(l4, block, radioss::inter_scales), start(l5, block, radioss::inter_start),
        friction(l6, block, radioss::type7_friction);
    contact.first = side_of_nodes(sides.integer("grnod_ID"), l1.place);
    contact.second = side_of_surface(sides.integer("surf_ID"), l1.place);
    if (contact.first == contact.second) contact.second = {};
    read_times(scales, contact);
  }

  void read_type11(const RadiossBlock& block, RadiossContact& contact) {
    RadiossLines lines(block);
    const DataLine l1 = lines.require("the lines"), l2 = lines.next_or_blank(), l3 = lines.next_or_blank(),
                   l4 = lines.next_or_blank(), l5 = lines.next_or_blank();
    const RadiossFields sides(l1, block, radioss::type11_sides), stiffness(l2, block, radioss::type11_stiffness),
        scales(l3, block, radioss::inter_scales), start(l4, block, radioss::inter_start),
        friction(l5, block, radioss::type11_friction);
    contact.first = side_of_line(sides.integer("line_IDs"), l1.place);
    contact.second = side_of_line(sides.integer("line_IDm"), l1.place);
    if (contact.first == contact.second) contact.second = {};
    read_times(scales, contact);
    data_.report.understood(fmt::format("{}: the faces of its edges touch, too", contact.card.text()));
  }

  /// TYPE24 and TYPE25: two surfaces, or one with itself, or nodes and a surface.
  void read_type24(const RadiossBlock& block, RadiossContact& contact) {
    RadiossLines lines(block);
    const DataLine l1 = lines.require("the surfaces"), l2 = lines.next_or_blank(), l3 = lines.next_or_blank(),
                   l4 = lines.next_or_blank(), l5 = lines.next_or_blank(), l6 = lines.next_or_blank();
    const RadiossFields sides(l1, block, radioss::type24_sides), gap(l2, block, radioss::type24_gap),
        stiffness(l3, block, radioss::type24_stiffness), scales(l4, block, radioss::type24_scales),
        start(l5, block, radioss::type24_start), friction(l6, block, radioss::type24_friction);
    const std::int64_t first = sides.integer("surf_ID1"), second = sides.integer("surf_ID2"),
                       nodes = gap.integer("grnd_IDs");
    if (nodes != 0 && first != 0 && second != 0)
      data_.report.reject(l2.place, block.title + " with two surfaces and nodes", "give an /INTER for the nodes");
    if (nodes != 0 && first == 0) {
      contact.first = side_of_nodes(nodes, l2.place);
      contact.second = side_of_surface(second, l1.place);
    } else if (nodes != 0 && second == 0) {
      contact.first = side_of_nodes(nodes, l2.place);
      contact.second = side_of_surface(first, l1.place);
      data_.report.reject(l2.place, block.title + " of a surface with itself and with nodes", "give an /INTER of each");
    } else {
      contact.first = side_of_surface(first != 0 ? first : second, l1.place);
      if (first != 0 && second != 0) contact.second = side_of_surface(second, l1.place);
    }
    if (contact.first == contact.second) contact.second = {};
    read_times(scales, contact);
  }

  void read_tie(const RadiossBlock& block, RadiossContact& contact) {
    RadiossLines lines(block);
    const DataLine line = lines.require("the nodes and the surface");
    const RadiossFields f(line, block, radioss::tie);
    contact.tied = true;
    contact.first = side_of_nodes(f.integer("grnd_IDs"), line.place);
    contact.second = side_of_surface(f.integer("surf_IDm"), line.place);
    const std::int64_t flag = f.integer("Spotflag");
    if (flag >= 20 && flag <= 22) {
      data_.report.reject(line.place, fmt::format("{} with Spotflag {}, of ties that break", block.title, flag),
                          "give 1: ties hold for ever");
    } else if (flag != 0) {
      data_.report.unused(line.place, fmt::format("{}: Spotflag", block.title),
                          "nodes that are tied are put on their faces");
    }
    const double distance = f.number("dsearch");
    if (distance > 0) contact.tolerance = distance;
  }

  RadiossData& data_;
  WholeSurfaces whole_;
};

template <class Keys>
void set_sides(const RadiossContact& contact, const Keys& keys) {
  keys.set("name", contact.name);
  keys.set("first", contact.first.given());
  if (!contact.second.empty()) keys.set("second", contact.second.given());
  if (contact.start > 0) keys.set("start", contact.start, "Tstart");
  if (contact.end > 0) keys.set("end", contact.end, "Tstop");
}

/// A lone surface of all parts that touches itself needs no pairs.
bool is_contact_of_all(const RadiossData& data, const std::vector<RadiossContact>& touching) {
  const RadiossContact& only = touching.front();
  return touching.size() == 1 && only.second.empty() && only.first.kind.empty() &&
         only.first.bodies == data.all_bodies() && only.start == 0 && only.end == 0;
}

void write_touching(RadiossData& data, const std::vector<RadiossContact>& touching, DeckScene& scene) {
  const auto all = scene.table<ContactSettings>("contact", touching.front().card);
  all.set("method", "pinball");
  if (is_contact_of_all(data, touching)) {
    all.set("friction", touching.front().friction, "Fric");
  } else {
    for (const RadiossContact& contact : touching) {
      const auto pair = scene.entry<ContactPair>("contact.pair", contact.card);
      set_sides(contact, pair);
      pair.set("friction", contact.friction, "Fric");
    }
  }
  for (const RadiossContact& contact : touching)
    data.report.understood(fmt::format("{}: exact contact of faces and edges, without penalties", contact.card.text()));
  if (touching.size() > 1)
    data.report.understood("where several contacts name the same two surfaces, the last one counts");
}

}  // namespace

bool translate_radioss_contact(RadiossData& data, DeckScene& scene) {
  ContactReader reader(data);
  std::vector<RadiossContact> touching, tied;
  GivenOnce given;
  for (const RadiossBlock& block : data.deck.blocks) {
    const RadiossRule* rule = radioss_rule_of(block.name);
    if (!block.name.starts_with("INTER/") || rule == nullptr || rule->treatment != Treatment::done) continue;
    given.add(fmt::format("contact {}", block.id()), block.place);
    const RadiossContact contact = reader.read(block);
    (contact.tied ? tied : touching).push_back(contact);
  }
  if (touching.empty()) {
    const auto keys = scene.table<ContactSettings>("contact", {});
    keys.comment("of which no keyword says anything");
    keys.set("method", "none");
  } else {
    write_touching(data, touching, scene);
  }
  for (const RadiossContact& contact : tied) {
    const auto keys = scene.entry<TiedContact>("contact.tied", contact.card);
    set_sides(contact, keys);
    if (contact.tolerance >= 0) keys.set("tolerance", contact.tolerance, "dsearch");
    data.report.understood(fmt::format("{}: nodes of the first side are tied to faces of the second, and put on them",
                                       contact.card.text()));
  }
  return !touching.empty();
}

}  // namespace pinball
