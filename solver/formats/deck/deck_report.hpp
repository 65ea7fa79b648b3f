#pragma once

#include <map>
#include <string>
#include <vector>

#include "deck_place.hpp"

namespace pinball {

/// What of a deck is done, ignored and refused, gathered until all of it is known.
class DeckReport {
 public:
  void understood(const std::string& line) { understood_.push_back(line); }
  /// Something that stands in a keyword that is done, and has not become anything.
  void unused(const DeckPlace& place, const std::string& what, const std::string& reason = "") {
    count(unused_, what, place, reason);
  }
  void ignore(const DeckPlace& place, const std::string& what) { count(ignored_, what, place, ""); }
  /// A node of no solid that a keyword names: it has no mass, and nothing moves with it.
  void ignore_node(const DeckPlace& place, const std::string& star_name) {
    ignore(place, star_name + " of a node of no solid");
  }
  /// --lenient: not known, so that nobody knows whether it changes the answer.
  void leave_out(const DeckPlace& place, const std::string& what) { count(left_out_, what, place, ""); }
  /// A keyword, or something of one that is done otherwise. elements: how many of them that is; -1: it is none of
  /// elements.
  void reject(const DeckPlace& place, const std::string& what, const std::string& reason = "", int elements = -1) {
    if (elements != 0) count(rejected_, what, place, reason, elements);
  }

  bool rejects() const { return !rejected_.empty(); }
  /// What is wrong besides.
  void add_error(const std::string& error) { errors_.push_back(error); }

  /// Throws InputError with all that is refused, if there is anything.
  void require_all_done(const std::string& file) const;
  /// With what is unused behind all else.
  std::vector<std::string> understood() const;
  std::vector<std::string> ignored() const;

 private:
  struct Count {
    std::string what, reason;
    DeckPlace first;
    int times = 0;
    bool of_elements = false;
  };
  static void count(std::vector<Count>& counts, const std::string& what, const DeckPlace& place,
                    const std::string& reason, int elements = -1);
  static std::string line(const Count& one);

  std::vector<std::string> understood_, errors_;
  std::vector<Count> ignored_, unused_, rejected_, left_out_;
};

}  // namespace pinball
