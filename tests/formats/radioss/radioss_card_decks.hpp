#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radioss_case.hpp"

/// A small deck for each keyword that is read, in which each of its fields can be set to something else.
namespace pinball::test {

struct RadiossCardDeck {
  std::string keyword;                   ///< as in radioss_cards()
  std::string header;                    ///< "/MAT/ELAST/1"
  std::vector<std::string> lines;        ///< fields between commas
  std::string others{};                  ///< what it needs beside the two cubes, or in the place of what they have
  std::vector<std::string_view> same{};  ///< fields of which other values mean the same here
  bool engine = false;                   ///< whether it is of the engine's input
};

/// What stands in each deck that has not the same header otherwise: two cubes of elastic steel, one above the other,
/// groups, a function, a box, a local system.
inline std::vector<std::string> common_radioss_blocks() {
  return {
      "/BEGIN\n" + radioss_begin.substr(radioss_begin.find('\n') + 1),
      radioss_steel,
      radioss_property,
      "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1) + square_nodes(9, 1.5) + square_nodes(13, 2.5) + ten({"99"}),
      "/PART/1\nlower\n" + ten({"1", "1", "0"}),
      "/PART/2\nupper\n" + ten({"1", "1", "3"}),
      "/SUBSET/3\nsome\n",
      "/BRICK/1\n" + ten({"1", "1", "2", "3", "4", "5", "6", "7", "8"}),
      "/BRICK/2\n" + ten({"2", "9", "10", "11", "12", "13", "14", "15", "16"}),
      "/GRNOD/NODE/5\ntop\n" + ten({"5", "6", "7", "8"}),
      "/GRNOD/PART/6\nupper\n" + ten({"2"}),
      "/GRNOD/NODE/8\nmain\n" + ten({"99"}),
      "/GRBRIC/BRIC/5\nlower\n" + ten({"1"}),
      "/SURF/SEG/5\ntop\n" + ten({"0", "5", "6", "7", "8"}),
      "/SURF/PART/EXT/6\nupper\n" + ten({"2"}),
      "/LINE/SURF/5\nlower\n" + ten({"5"}),
      "/LINE/SURF/6\nupper\n" + ten({"6"}),
      "/BOX/RECTA/5\nlow\n\n" + twenty({-1, -1, -1}) + twenty({2, 2, 1.2}),
      "/SKEW/FIX/5\ntilted\n\n" + twenty({1, 2, 3}) + twenty({3, -1, 0.5}),
      "/FRAME/FIX/5\ntilted\n" + twenty({0.1, 0.2, 0.3}) + twenty({1, 2, 3}) + twenty({3, -1, 0.5}),
      "/FUNCT/5\nf\n" + twenty({0, 1}) + twenty({1, 2})};
}

namespace of_radioss {

/// Who uses what a keyword defines.
inline const std::string held = "/BCS/1\nb\n   111 000         0         5\n",
                         loaded = "/CLOAD/1\nl\n" + ten({"5", "X", "5", "0", "5"}),
                         spinning = "/INIVEL/AXIS/1\nv\n" + ten({"Z", "5", "0"}) + twenty({1, 2, 3, 4}),
                         plastic = "/MAT/PLAS_JOHNS/1\nm\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}) +
                                   twenty({400, 500, 0.5}) + twenty({0.02, 1}),
                         hydrodynamic = "/MAT/HYD_JCOOK/1\nm\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3}) +
                                        twenty({400, 500, 0.5}) + "\n" + twenty({0.02, 1}) + "\n";
inline const std::vector<std::string> scales{",,", ",,,", "1,0.2", "", ""};

/// Both cubes as rigid bodies of their own, with a node of each in one place between them, and a part of springs.
inline std::string two_rigid_cubes() {
  return "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1) + square_nodes(9, 1.5) + square_nodes(13, 2.5) +
         ten({"98"}) + ten({"99"}) + fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 96, 0.5, 0.5, 1.25) +
         fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 97, 0.5, 0.5, 1.25) + "/GRNOD/NODE/21\nlower\n" +
         ten({"1", "2", "3", "4", "5", "6", "7", "8", "96"}) + "/GRNOD/NODE/22\nupper\n" +
         ten({"9", "10", "11", "12", "13", "14", "15", "16", "97"}) + "/RBODY/1\nlower\n" +
         ten({"98", "0", "0", "0", "-", "-", "21"}) + "/RBODY/2\nupper\n" + ten({"99", "0", "0", "0", "-", "-", "22"}) +
         "/PART/3\nsprings\n" + ten({"2", "0", "0"});
}

/// The nodes of both cubes, and those in the middles between 1, 2, 4 and 5.
inline std::string nodes_with_middles() {
  const double middles[6][3] = {{0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
  std::string lines =
      "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1) + square_nodes(9, 1.5) + square_nodes(13, 2.5) + ten({"99"});
  for (int i = 0; i < 6; ++i)
    lines += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 20 + i, middles[i][0], middles[i][1], middles[i][2]);
  return lines;
}

/// The nodes of both cubes, and of the lower one those in the middles of its edges: 31 to 34 of its base, 35 to 38 of
/// what stands on that, 39 to 42 of its top.
inline std::string nodes_of_edges() {
  const double middles[12][3] = {{0.5, 0, 0}, {1, 0.5, 0}, {0.5, 1, 0}, {0, 0.5, 0}, {0, 0, 0.5}, {1, 0, 0.5},
                                 {1, 1, 0.5}, {0, 1, 0.5}, {0.5, 0, 1}, {1, 0.5, 1}, {0.5, 1, 1}, {0, 0.5, 1}};
  std::string lines =
      "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1) + square_nodes(9, 1.5) + square_nodes(13, 2.5) + ten({"99"});
  for (int i = 0; i < 12; ++i)
    lines += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 31 + i, middles[i][0], middles[i][1], middles[i][2]);
  return lines;
}

/// The nodes of both cubes, and a plate of a shell above them, at rest, but for what is named.
inline std::string held_plate(const std::string& without) {
  const std::vector<std::string> all{"/SHELL/3\n" + ten({"30", "21", "22", "23", "24"}),
                                     "/PROP/SHELL/3\nplate\n\n\n" + fmt::format("{:>40}\n", 0.2)};
  std::string text = "/NODE\n" + square_nodes(1, 0) + square_nodes(5, 1) + square_nodes(9, 1.5) +
                     square_nodes(13, 2.5) + ten({"99"}) + square_nodes(21, 4) + "/PART/3\nplate\n" +
                     ten({"3", "1", "0"}) + "/GRNOD/PART/9\nplate\n" + ten({"3"}) +
                     "/BCS/9\nb\n   111 111         0         9\n";
  for (const std::string& block : all) {
    if (!block.starts_with(without)) text += block;
  }
  return text;
}

/// A group by its members, in the place of the one of this header that is there, used or not.
inline RadiossCardDeck group(const std::string& keyword, const std::string& members, int number = 15) {
  return {keyword, "/" + keyword + "/" + std::to_string(number), {members}};
}

}  // namespace of_radioss

inline std::vector<RadiossCardDeck> radioss_card_decks() {
  using namespace of_radioss;
  std::vector<RadiossCardDeck> decks{
      {"BEGIN", "/BEGIN", {"cube", "2022,0", "Mg,mm,s", "Mg,mm,s"}, "", {"run_name", "Invers"}},
      {"UNIT", "/UNIT/4", {"Mg,mm,s"}, "/MAT/ELAST/1/4\nsteel\n" + twenty({7.85e-9, 0}) + twenty({210000, 0.3})},
      {"NODE",
       "/NODE",
       {"1,0,0,0", "2,1,0,0", "3,1,1,0", "4,0,1,0", "5,0,0,1", "6,1,0,1", "7,1,1,1", "8,0,1,1", "9,0,0,1.5",
        "10,1,0,1.5", "11,1,1,1.5", "12,0,1,1.5", "13,0,0,2.5", "14,1,0,2.5", "15,1,1,2.5", "16,0,1,2.5", "99,0,0,0"}},
      {"BRICK", "/BRICK/1", {"1,1,2,3,4,5,6,7,8"}},
      {"PENTA6", "/PENTA6/1", {"3,1,2,4,5,6,8"}},
      {"TETRA4", "/TETRA4/1", {"3,1,2,4,5"}},
      {"TETRA10", "/TETRA10/1", {"3", "1,2,4,5,20,21,22,23,24,25"}, nodes_with_middles()},
      {"BRIC20",
       "/BRIC20/1",
       {"3,1,2,3,4,5,6,7,8", "31,32,33,34,35,36,37,38", "39,40,41,42"},
       nodes_of_edges(),
       {"bric_ID"}},
      {"SHELL", "/SHELL/3", {"30,21,22,23,24"}, held_plate("/SHELL")},
      {"SH3N", "/SH3N/3", {"30,21,22,23"}, held_plate("/SHELL")},
      {"PROP/SHELL", "/PROP/SHELL/3", {"", "", "0,0,0.2"}, held_plate("/PROP")},
      {"PART", "/PART/2", {"1,1,3"}, "/GRNOD/SUBSET/7\ns\n" + ten({"3"})},
      {"SUBSET",
       "/SUBSET/3",
       {""},
       "/PART/1\nlower\n" + ten({"1", "1", "1"}) + "/SUBSET/1\ns\n/SUBSET/2\ns\n" + ten({"1"}) + "/SUBSET/7\ns\n" +
           ten({"1"}) + "/GRNOD/SUBSET/7\ns\n" + ten({"3"})},
      {"SURF/SEG", "/SURF/SEG/5", {"0,5,6,7,8"}},
      {"BOX/RECTA",
       "/BOX/RECTA/5",
       {"0,0,0", "-1,-1,-1", "2,2,1.2"},
       "/GRNOD/BOX/7\nb\n" + ten({"5"}),
       {"Xp1", "Yp1", "Zp1", "Xp2", "Yp2"}},
      {"SKEW/FIX", "/SKEW/FIX/5", {"0,0,0", "1,2,3", "3,-1,0.5"}, loaded},
      {"FRAME/FIX", "/FRAME/FIX/5", {"0.1,0.2,0.3", "1,2,3", "3,-1,0.5"}, spinning},
      {"FUNCT", "/FUNCT/5", {"0,1", "1,2"}, loaded},
      {"PROP/SOLID", "/PROP/SOLID/1", {"24,0", "0,0,0", "0"}},
      {"DEF_SOLID", "/DEF_SOLID", {"24,0"}},
      {"MAT/ELAST", "/MAT/ELAST/1", {"7.85E-9", "210000.,0.3"}},
      {"MAT/RIGID", "/MAT/RIGID/1", {"7.85E-9", "210000.,0.3"}},
      {"MAT/PLAS_JOHNS", "/MAT/PLAS_JOHNS/1", {"7.85E-9", "210000.,0.3", "400.,500.,0.5", "", ""}},
      {"MAT/PLAS_JOHNS", "/MAT/PLAS_JOHNS/1", {"7.85E-9", "210000.,0.3", "400.,500.,1", "", ""}},
      {"MAT/PLAS_JOHNS", "/MAT/PLAS_JOHNS/1", {"7.85E-9", "210000.,0.3", "400.,500.,0.5", "0.02,1.5", "1.1,1500.,3.5"}},
      {"MAT/HYDPLA",
       "/MAT/HYDPLA/1",
       {"7.85E-9", "210000.,0.3", "400.,500.,0.5", ""},
       "/EOS/POLYNOMIAL/1\ne\n" + twenty({0, 175000})},
      {"MAT/HYD_JCOOK",
       "/MAT/HYD_JCOOK/1",
       {"7.85E-9", "210000.,0.3", "400.,500.,0.5", "-1000.", "0.02,1.5,1.1,1500.", "3.5"},
       "/EOS/POLYNOMIAL/1\ne\n" + twenty({0, 175000})},
      {"MAT/HYD_JCOOK",
       "/MAT/HYD_JCOOK/1",
       {"7.85E-9", "210000.,0.3", "400.,500.,0.5", "", "", ""},
       "/EOS/POLYNOMIAL/1\ne\n" + twenty({0, 175000})},
      {"MAT/PLAS_TAB",
       "/MAT/PLAS_TAB/1",
       {"7.85E-9", "210000.,0.3", "1", "", "5", "100.", ""},
       "",
       {"func_ID2", "func_ID3", "func_ID4", "func_ID5", "Fscale_2", "Fscale_3", "Fscale_4", "Fscale_5", "Eps_dot_2",
        "Eps_dot_3", "Eps_dot_4", "Eps_dot_5"}},
      {"MAT/PLAS_TAB",
       "/MAT/PLAS_TAB/1",
       {"7.85E-9", "210000.,0.3", "5", "", "5,5,5,5,5", "100.,110.,120.,130.,140.", "0.1,1,2.5,3,4"}},
      {"MAT/COWPER", "/MAT/COWPER/1", {"7.85E-9", "210000.,0.3", "180.,450.,0.5,,300.", "400.,5.", "", ""}},
      {"MAT/COWPER", "/MAT/COWPER/1", {"7.85E-9", "210000.,0.3", "180.,450.,1", "", "", ""}},
      {"MAT/OGDEN",
       "/MAT/OGDEN/1",
       {"1.E-9", "0.4,0,,0,0,0,0", "3.,-1.,3.,-1.,3.", "-1.,3.,-1.,3.,-1.", "2,-2,2,-2,2", "-2,2,-2,2,-2"},
       "",
       {"Iform"}},
      {"MAT/VISC_HYP",
       "/MAT/VISC_HYP/1",
       {"1.E-9", "0.4,10", "3.,-1.,3.,-1.,3.", "-1.,3.,-1.,3.,-1.", "2,-2,2,-2,2", "-2,2,-2,2,-2"}},
      {"MAT/JOHN_HOLM",
       "/MAT/JOHN_HOLM/1",
       {"7.85E-9", "80000.", "0.9,0.3,0.6,0.7", "0.01,1.,0.5", "200.,2800.,1400.", "0.01,0.9,,2,0.5",
        "170000.,1E4,2E4,0.9"}},
      {"MAT/JOHN_HOLM", "/MAT/JOHN_HOLM/1", {"7.85E-9", "80000.", "0.9", "", "200.,2800.,1400.", "0,0,,3", "170000."}},
      {"MAT/DPRAG",
       "/MAT/DPRAG/1",
       {"1.8E-9", "210.,0.3", "100.,30.,0.3,9000.", "6,,900.,1.", "-2.,0", "950.,0.5"},
       "/FUNCT/6\ng\n" + twenty({0, 0}) + twenty({0.1, 5}) + twenty({0.2, 30})},
      {"MAT/DPRAG1",
       "/MAT/DPRAG1/1",
       {"1.8E-9", "210.,0.3", "100.,30.,0.3,9000.", "0,500.,300.,100.", "-2.,0", "950.,0.5"}},
      {"MAT/FOAM_PLAS",
       "/MAT/FOAM_PLAS/1",
       {"6.E-11", "20.,2,6,1.", "0.1,0.05", ",,,0.1"},
       "/FUNCT/6\ng\n" + twenty({-0.7, 4}) + twenty({-0.1, 0.3}) + twenty({0, 0.2}),
       {"A", "B", "C"}},
      {"EOS/COMPACTION", "/EOS/COMPACTION/1", {"0,175000.,1E4,2E4,,2", "0.01,0.3,3E5", ""}, hydrodynamic},
      {"EOS/COMPACTION2",
       "/EOS/COMPACTION2/1",
       {",6,1.E6,1.,,2", "0.01,0.3,2E5,3E5", ""},
       hydrodynamic + "/FUNCT/6\ng\n" + twenty({0, 0}) + twenty({0.1, 0.01}) + twenty({0.2, 0.03})},
      {"EOS/LINEAR", "/EOS/LINEAR/1", {"0,175000."}, hydrodynamic},
      {"EOS/GRUNEISEN", "/EOS/GRUNEISEN/1", {"4.5E6,1.5", "1.7"}, hydrodynamic},
      {"EOS/POLYNOMIAL", "/EOS/POLYNOMIAL/1", {"0,175000.", ""}, hydrodynamic},
      {"FAIL/JOHNSON", "/FAIL/JOHNSON/1", {"0.1,0.2,-1.5,0.01", "1", ""}, plastic},
      {"BCS", "/BCS/1", {"   010 000,0,5"}},
      {"INIVEL/TRA", "/INIVEL/TRA/1", {"1.5,2.5,3.5,5", ""}},
      {"INIVEL/ROT",
       "/INIVEL/ROT/1",
       {"0.1,0.2,0.3,8,0", ""},
       "/RBODY/1\nupper\n" + ten({"99", "0", "0", "0", "-", "-", "6"})},
      {"INIVEL/AXIS", "/INIVEL/AXIS/1", {"Z,5,5", "1.5,2.5,3.5,4.5", ""}},
      {"INIBRI/STRESS", "/INIBRI/STRESS", {"1,1.,2.,3.", "4.,5.,6."}},
      {"INIBRI/EPSP", "/INIBRI/EPSP", {"1,0.01"}},
      {"INIBRI/STRS_FGLO", "/INIBRI/STRS_FGLO", {"1,1,8,1", "", "1.,2.,3.", "4.,5.,6.", "0.01"}, "", {"Isolid"}},
      {"CLOAD", "/CLOAD/1", {"5,X,0,0,5"}},
      {"PLOAD", "/PLOAD/1", {"5,5"}},
      {"GRAV", "/GRAV/1", {"5,Z,0,0,6"}},
      {"RWALL/PLANE", "/RWALL/PLANE/1", {"0,2,5,0", "0.2,0.1", "0.1,0.1,-0.3", "0.2,0.1,0.7"}},
      {"RBODY", "/RBODY/1", {"99,0,0,,,6", "", "", ""}, "", {"ICoG"}},
      {"PROP/KJOINT2",
       "/PROP/KJOINT2/2",
       {"1,0,0,0,0,0,0", "0,0,0,0,0", "0,0", "0,0,0"},
       two_rigid_cubes() + "/SPRING/3\n" + ten({"70", "96", "97"})},
      {"SPRING",
       "/SPRING/3",
       {"70,96,97,0,0"},
       two_rigid_cubes() + "/PROP/KJOINT2/2\njoint\n" + ten({"1"}) + "\n\n\n\n\n\n\n\n\n"},
      {"ADMAS",
       "/ADMAS/0/1",
       {"1.5e-9,8"},
       "/GRNOD/NODE/8\nm\n" + ten({"99"}) + "/RBODY/1\nupper\n" + ten({"99", "0", "0", "0", "-", "-", "6"})},
      {"DAMP", "/DAMP/1", {"1.5", ""}},
      {"TH/NODE",
       "/TH/NODE/1",
       {"DEF", "5,0,name"},
       "",
       {"var1", "var2", "var3", "var4", "var5", "var6", "var7", "var8", "var9", "var10", "name"}},
      {"TH/BRIC",
       "/TH/BRIC/1",
       {"DEF", "1,name"},
       "",
       {"var1", "var2", "var3", "var4", "var5", "var6", "var7", "var8", "var9", "var10", "name"}},
      {"INTER/TYPE2", "/INTER/TYPE2/1", {"5,6"}},
      {"INTER/TYPE7", "/INTER/TYPE7/1", {"5,6", ",,", ",,,", ",0.2", "", ""}},
      {"INTER/TYPE11", "/INTER/TYPE11/1", {"5,6", ",,", ",0.2", "", ""}},
      {"INTER/TYPE24", "/INTER/TYPE24/1", {"5,6", "", "", ",0.2", "", ""}},
      {"INTER/TYPE25", "/INTER/TYPE25/1", {"5,6", "", "", ",0.2", "", ""}},
      {"ANALY", "/ANALY", {""}},
      {"RANDOM", "/RANDOM", {""}},
      {"RUN", "/RUN/cube/1", {"1.0E-6"}, "", {}, true},
      {"DT", "/DT", {"0.8,0"}, "", {}, true},
      {"DT/BRICK/STOP", "/DT/BRICK/STOP", {"0.8,0"}, "", {}, true},
      {"DT/BRICK/CST", "/DT/BRICK/CST/0", {"0.8,0"}, "", {}, true},
      {"DT/NODA", "/DT/NODA", {"0.8,0"}, "", {}, true},
      {"DT/NODA/CST", "/DT/NODA/CST/0", {"0.8,0"}, "", {}, true},
      {"DTIX", "/DTIX", {"0,0"}, "", {}, true},
      {"STOP", "/STOP", {"0,0,0,0,0,0"}, "", {}, true},
      {"KILL", "/KILL", {"0,0,0,0,0,0"}, "", {}, true},
      {"TFILE", "/TFILE/4", {"1.0E-7"}, "", {}, true},
      {"ANIM/DT", "/ANIM/DT", {"0,1.0E-7"}, "", {}, true}};
  for (const char* keyword : {"IMPVEL", "IMPDISP", "IMPACC"})
    decks.push_back({keyword, std::string("/") + keyword + "/1", {"5,X,0,0,5", ""}});
  for (const char* keyword :
       {"GRNOD/NODE", "GRNOD/PART", "GRNOD/MAT", "GRNOD/PROP", "GRBRIC/BRIC", "GRBRIC/PART", "GRBRIC/MAT",
        "GRBRIC/PROP", "SURF/PART/EXT", "SURF/PART/ALL", "SURF/MAT/EXT", "SURF/PROP/EXT"})
    decks.push_back(group(keyword, "1"));
  for (const char* keyword : {"GRNOD/SUBSET", "GRBRIC/SUBSET", "SURF/SUBSET/EXT"}) decks.push_back(group(keyword, "3"));
  for (const char* keyword : {"GRNOD/GRNOD", "GRNOD/GRBRIC", "GRNOD/SURF", "GRNOD/BOX", "GRBRIC/GRBRIC", "GRBRIC/BOX",
                              "SURF/SURF", "SURF/GRBRIC/EXT", "LINE/SURF"})
    decks.push_back(group(keyword, "5"));
  decks.push_back(group("GRNOD/GENE", "1,2"));
  decks.push_back(group("GRBRIC/GENE", "1,1"));
  decks.push_back(group("GRNOD/GEN_INCR", "1,9,4"));
  decks.push_back(group("GRBRIC/GEN_INCR", "1,2,1"));
  decks.back().same = {"Ilast"};  // there are two solids
  return decks;
}

}  // namespace pinball::test
