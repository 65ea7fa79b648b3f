#pragma once

#include <string>
#include <string_view>

#include <solver/formats/deck/layout_fields.hpp>

#include "radioss_block.hpp"

namespace pinball {

/// The fields of a line of Radioss input by their names in its layout. Those of the starter stand in columns, those of
/// the engine between blanks.
class RadiossFields final : public LayoutFields {
 public:
  RadiossFields(const DataLine& line, const RadiossBlock& block, const CardLayout& layout);
  ~RadiossFields() { write_down_unread(); }
  RadiossFields(const RadiossFields&) = delete;
  RadiossFields& operator=(const RadiossFields&) = delete;

 private:
  std::string keyword() const override { return block_->title + ": "; }
  void cut_columns(std::string_view line);
  void cut_at_blanks(std::string_view line);

  const RadiossBlock* block_;
};

}  // namespace pinball
