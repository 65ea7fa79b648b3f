#pragma once

#include <string>
#include <string_view>

#include <solver/formats/deck/layout_fields.hpp>

#include "keyword_block.hpp"
#include "parameters.hpp"

namespace pinball {

/// The fields of a card of LS-DYNA by their names in its layout, which has their columns, defaults, bounds and units:
/// numbers are in those of the deck.
class Fields final : public LayoutFields {
 public:
  Fields(const Card& card, const Parameters& parameters, const CardLayout& layout);
  ~Fields() { write_down_unread(); }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

 private:
  std::string meant(std::string_view given) const override;
  std::string keyword() const override;
  double factor(Dimension dimension) const override;
  void cut_columns(std::string_view line);

  const Parameters* parameters_;
  const KeywordBlock* block_;
};

}  // namespace pinball
