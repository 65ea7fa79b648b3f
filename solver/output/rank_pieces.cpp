#include "rank_pieces.hpp"

#include <algorithm>
#include <exception>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/scene_rules.hpp>

#include "run_files.hpp"

namespace pinball {

namespace {

FieldPiece own_piece(const Simulation& simulation) {
  return cut_piece(simulation.own_snapshot(), simulation.field_base(), simulation.rank_of_elements(),
                   simulation.rank());
}

/// Returns what has gone wrong; a rank without elements writes nothing.
std::string write_own(const Simulation& simulation, const FieldPiece& piece, const std::string& folder,
                      std::int64_t number) {
  if (piece.snapshot.hexahedra.empty()) return "";
  try {
    const Scene& scene = simulation.scene();
    write_vtu(in_folder(folder, piece_name(fields_base, number, simulation.rank())), piece.snapshot,
              scene.output.fields, scene.units, names_of(scene.bodies), piece.base);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

void write_pieces(Simulation& simulation, FieldWriter& fields) {
  const std::vector<std::int32_t> rank_of_element = simulation.rank_of_elements();
  FieldPiece any;
  const auto write = [&](Simulation& s, std::int64_t number) {
    any = own_piece(s);
    const std::string error = write_own(s, any, fields.folder(), number);
    // One without elements does not say what the others have.
    if (any.snapshot.hexahedra.empty()) {
      any = cut_piece(s.own_snapshot(), s.field_base(), rank_of_element, rank_of_element.front());
    }
    return error;
  };
  for (const std::string& error : simulation.ask_ranks(fields.next_number(), write)) {
    if (!error.empty()) throw RunError(error);
  }
  std::vector<std::int32_t> ranks = rank_of_element;
  std::ranges::sort(ranks);
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  fields.list_pieces(any, ranks);
}

RankAnswer answer_with_piece(const std::string& folder) {
  return [folder](Simulation& simulation, std::int64_t number) {
    return write_own(simulation, own_piece(simulation), folder, number);
  };
}

}  // namespace pinball
