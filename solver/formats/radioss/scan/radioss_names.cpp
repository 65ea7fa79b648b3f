#include "radioss_names.hpp"

#include <map>
#include <set>
#include <string_view>

namespace pinball {

std::string radioss_name(const std::string& words) {
  static const std::map<std::string, std::string> names{
      {"MAT/LAW0", "MAT/VOID"},        {"MAT/LAW00", "MAT/VOID"},       {"MAT/LAW1", "MAT/ELAST"},
      {"MAT/LAW01", "MAT/ELAST"},      {"MAT/LAW2", "MAT/PLAS_JOHNS"},  {"MAT/LAW02", "MAT/PLAS_JOHNS"},
      {"MAT/LAW3", "MAT/HYDPLA"},      {"MAT/LAW03", "MAT/HYDPLA"},     {"MAT/LAW4", "MAT/HYD_JCOOK"},
      {"MAT/LAW04", "MAT/HYD_JCOOK"},  {"MAT/LAW13", "MAT/RIGID"},      {"MAT/LAW36", "MAT/PLAS_TAB"},
      {"MAT/LAW33", "MAT/FOAM_PLAS"},  {"MAT/LAW21", "MAT/DPRAG"},      {"MAT/LAW10", "MAT/DPRAG1"},
      {"MAT/LAW62", "MAT/VISC_HYP"},   {"MAT/LAW42", "MAT/OGDEN"},      {"MAT/LAW79", "MAT/JOHN_HOLM"},
      {"MAT/LAW44", "MAT/COWPER"},     {"PROP/TYPE14", "PROP/SOLID"},   {"PROP/TYPE1", "PROP/SHELL"},
      {"PROP/TYPE0", "PROP/VOID"},     {"PROP/TYPE45", "PROP/KJOINT2"}, {"TH/BRICK", "TH/BRIC"},
      {"GRNOD/NODENS", "GRNOD/NODE"},  {"GRBRIC/BRICK", "GRBRIC/BRIC"}, {"GRBRICK/BRIC", "GRBRIC/BRIC"},
      {"GRBRICK/PART", "GRBRIC/PART"},
  };
  const auto found = names.find(words);
  return found == names.end() ? words : found->second;
}

bool radioss_has_title(const std::string& name) {
  static const std::set<std::string> titled{"PART",   "SUBSET", "FUNCT",   "BCS",  "CLOAD", "PLOAD", "GRAV",
                                            "IMPVEL", "IMPACC", "IMPDISP", "UNIT", "ADMAS", "DAMP",  "RBODY"};
  static constexpr std::string_view families[]{"MAT/",   "PROP/",   "GRNOD/", "GRBRIC/", "GRPART/",
                                               "SURF/",  "LINE/",   "EOS/",   "SKEW/",   "FRAME/",
                                               "INTER/", "INIVEL/", "RWALL/", "TH/",     "BOX/"};
  if (titled.contains(name)) return true;
  for (const std::string_view family : families) {
    if (name.starts_with(family)) return true;
  }
  return false;
}

}  // namespace pinball
