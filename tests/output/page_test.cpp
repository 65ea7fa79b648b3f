#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>

#include <solver/base/error.hpp>
#include <solver/output/history.hpp>
#include <solver/output/page/curves.hpp>
#include <solver/output/page/page.hpp>
#include <solver/output/page/resources.hpp>
#include <solver/output/page/units_json.hpp>
#include <solver/run_page.hpp>
#include <solver/scene/given/given_scene.hpp>
#include <solver/scene_rules.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>

namespace pinball::page_test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(Page, TextIsNoMarkup) {
  EXPECT_EQ(html_text("a < b & \"c\" 'd' >"), "a &lt; b &amp; &quot;c&quot; &#39;d&#39; &gt;");
  EXPECT_EQ(html_text("caf\xC3\xA9"), "caf\xC3\xA9");
  EXPECT_EQ(html_text("bad \xFF byte"), "bad \xEF\xBF\xBD byte");
}

TEST(Page, JsonCannotEndItsScript) {
  const std::string evil = "</script><!-- <script> & ]]>";
  const std::string text = json_for_script(Json(evil).dump());
  EXPECT_THAT(text, Not(testing::AnyOf(HasSubstr("<"), HasSubstr(">"), HasSubstr("&"))));
  EXPECT_EQ(Json::parse(text).get<std::string>(), evil);
}

TEST(Page, WhatIsPutIntoATemplateIsNotLookedThroughAgain) {
  EXPECT_EQ(fill_template("{{a}}-{{b}}-{{no such}}", {{"a", "{{b}}"}, {"b", "2"}}), "{{b}}-2-");
  EXPECT_EQ(fill_template("{{open", {}), "{{open");
}

TEST(Page, HasNothingFromOutside) {
  const std::string page =
      make_page({"t", "<main></main>", {"format.js", "axes.js", "curves.js", "pictures.js", "run.js"}, {}});
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"?(https?:)?//")));
  EXPECT_FALSE(std::regex_search(page, std::regex("@import|url\\(")));
}

Curves wave(std::size_t rows) {
  Curves curves{{"step", "time", "a"}, {}, rows};
  for (std::size_t r = 0; r < rows; ++r) {
    curves.rows.push_back(
        {static_cast<double>(r), 0.5 * static_cast<double>(r), std::sin(0.01 * static_cast<double>(r))});
  }
  return curves;
}

TEST(Curves, OfFewRowsStayAsTheyAre) {
  Curves curves = wave(2000);
  const auto rows = curves.rows;
  thin(curves, 2000);
  EXPECT_EQ(curves.rows, rows);
}

TEST(Curves, ThatAreThinnedKeepTheirPeaks) {
  Curves curves = wave(100'003);
  curves.rows[71'234][2] = 7;
  curves.rows[71'235][2] = -9;
  curves.rows[5][2] = std::numeric_limits<double>::quiet_NaN();
  const auto all = curves.rows;
  thin(curves, 2000);
  ASSERT_LE(curves.rows.size(), 2000U);
  EXPECT_GT(curves.rows.size(), 1900U);
  EXPECT_EQ(curves.rows.front(), all.front());
  EXPECT_EQ(curves.rows.back(), all.back());
  double low = 0, high = 0;
  for (std::size_t r = 0; r < curves.rows.size(); ++r) {
    if (r > 0) {
      EXPECT_GT(curves.rows[r][1], curves.rows[r - 1][1]) << "times increase";
    }
    const double value = curves.rows[r][2];
    if (value > high) {
      high = value;
      EXPECT_TRUE(value < 7 || std::abs(curves.rows[r][1] - 0.5 * 71'234) < 60) << "no further than a group";
    }
    low = std::min(low, value);
  }
  EXPECT_EQ(high, 7);
  EXPECT_EQ(low, -9);
  EXPECT_EQ(curves.all_rows, 100'003U);
}

TEST(Curves, ThatAreThinnedKeepTheirPeaksBesideWhatIsNoNumber) {
  Curves curves;
  curves.columns = {"time", "a"};
  for (int i = 0; i < 1000; ++i) {
    const double value = i == 500 ? -9.0 : i == 501 ? std::numeric_limits<double>::quiet_NaN() : i == 499 ? 9.0 : 0.0;
    curves.rows.push_back({static_cast<double>(i), value});
  }
  thin(curves, 10);
  std::vector<double> values;
  for (const auto& row : curves.rows) values.push_back(row[1]);
  EXPECT_THAT(values, testing::AllOf(testing::Contains(-9.0), testing::Contains(9.0)));
}

TEST(Curves, AreReadFromAHistoryWithNamesInQuotesAndNumbersThatAreNone) {
  const test::TemporaryFolder folder("page_curves");
  {
    HistoryWriter writer(folder.path.string(), {"a,b"});
    HistoryRow row;
    row.bodies.resize(1);
    row.time = 0.25;
    row.energy.kinetic = std::numeric_limits<double>::quiet_NaN();
    row.energy.internal = std::numeric_limits<double>::infinity();
    row.bodies[0].mass_remaining = 3.5;
    writer.write(row);
  }
  std::ofstream(folder / "history.csv", std::ios::app) << "1,0.5,cut off";
  const Curves curves = read_history(folder / "history.csv");
  EXPECT_EQ(curves.columns, history_column_names({"a,b"}, {}));
  ASSERT_EQ(curves.rows.size(), 1U) << "a row that is not whole is none";
  const Json json = Json::parse(curves_json(curves));
  EXPECT_EQ(json["columns"][20], "a,b_velocity_x");
  EXPECT_EQ(json["data"][1][0], 0.25);
  EXPECT_TRUE(json["data"][3][0].is_null());
  EXPECT_TRUE(json["data"][4][0].is_null());
  EXPECT_EQ(json["data"][23][0], 3.5);
  EXPECT_TRUE(read_history(folder / "nothing.csv").rows.empty());
}

TEST(PageUnits, FollowFromTheDimensions) {
  const Units inch = parse_units("in-lbf-s"), metre = parse_units("m-kg-s");
  EXPECT_EQ(unit_of("M/L^3", inch), "lbf s^2/in^4");
  EXPECT_EQ(unit_of("M/L^3", metre), "kg/m^3");
  EXPECT_EQ(unit_of("M/(L T^2)", inch), "psi");
  EXPECT_EQ(unit_of("1/T", metre), "1/s");
  EXPECT_EQ(unit_of("-", metre), "");
  EXPECT_EQ(unit_of("degree", metre), "degree");
  EXPECT_EQ(unit_of("L/T", parse_units("")), "");
}

Scene scene() {
  Scene scene;
  scene.name = "small";
  scene.time.end = 1;
  scene.materials = {{.name = "m",
                      .density = 1,
                      .bulk_modulus = 1,
                      .shear_modulus = 1,
                      .yield_curves = {},
                      .power_hardening = {},
                      .johnson_cook = {},
                      .johnson_holmquist = {},
                      .drucker_prager = {},
                      .crushable_foam = {},
                      .mooney_rivlin = {},
                      .ogden = {},
                      .orthotropic = {},
                      .fluid = {},
                      .equation_of_state = {},
                      .erosion = {}}};
  scene.bodies.resize(1);
  scene.bodies[0].name = "b";
  scene.bodies[0].material = "m";
  scene.bodies[0].mesh = BlockMesh{{1, 1, 1}, {1, 1, 1}};
  return checked_scene(scene);
}

/// What a <script type="application/json"> of the page holds.
Json block(const std::string& page, const std::string& id) {
  const std::string begin = "<script type=\"application/json\" id=\"" + id + "\">";
  const auto from = page.find(begin);
  if (from == std::string::npos) return {};
  return Json::parse(page.substr(from + begin.size(), page.find("</script>", from) - from - begin.size()));
}

class RunPage : public testing::Test {
 protected:
  std::string page(const RunPageSettings& settings = {}, const Scene& of = scene()) {
    RunSummary summary;
    summary.scene = "small";
    summary.title = "Tit</title><script>le\xFF";
    summary.units = "m-kg-s";
    summary.threads = 3;
    summary.energy.kinetic = std::numeric_limits<double>::quiet_NaN();
    write_run_page(folder_.path.string(), of, summary, settings);
    return test::content(folder_ / "index.html");
  }
  test::TemporaryFolder folder_{"run_page"};
};

TEST_F(RunPage, HasTheNumbersAndEveryKey) {
  const std::string text = page();
  EXPECT_THAT(text, HasSubstr("<h1>Tit&lt;/title&gt;&lt;script&gt;le\xEF\xBF\xBD</h1>"));
  EXPECT_TRUE(block(text, "summary")["energy"]["kinetic"].is_null());
  EXPECT_EQ(block(text, "units")["force"], "N");
  EXPECT_TRUE(block(text, "history")["data"].empty()) << "there is no history.csv";
  const Json keys = block(text, "scene")["keys"];
  EXPECT_THAT(keys, testing::Contains(Json{"time.end", "1", "s", false}));
  EXPECT_THAT(keys, testing::Contains(Json{"contact.skin", "0.5", "", true}));
  EXPECT_FALSE(block(text, "scene").contains("command")) << "a host's scene has no file";
  EXPECT_THAT(text, HasSubstr("<!-- pictures -->"));
  EXPECT_THAT(text, HasSubstr("<!-- /pictures -->"));
  EXPECT_THAT(text, HasSubstr("id=\"status\">done<"));
}

/// A deck may have a load for each of its nodes.
TEST_F(RunPage, HasTheFirstOfManyTables) {
  Scene many = scene();
  many.loads.resize(50'000);
  const std::string text = page({}, many);
  EXPECT_LT(text.size(), 2'000'000U) << "of one load alone: " << page().size();
  const Json keys = block(text, "scene")["keys"];
  EXPECT_EQ(keys.back()[0], "load");
  EXPECT_THAT(std::string(keys.back()[1]), testing::MatchesRegex("and [0-9]+ keys more"));
  EXPECT_THAT(keys, testing::Contains(Json{"time.end", "1", "s", false}));
}

/// Numbers beyond those of a double are none; the row counts, and so does what stands behind them.
TEST_F(RunPage, LeavesOutNumbersThatAreNone) {
  const std::string path = (folder_.path / "history.csv").string();
  std::ofstream(path) << "step,time,kinetic\n1,1e999,3\n2,0.5,-1e-999\n3,inf,7\n4,x,9\n";
  const Curves curves = read_history(path);
  ASSERT_EQ(curves.rows.size(), 3U);
  EXPECT_TRUE(std::isnan(curves.rows[0][1]));
  EXPECT_EQ(curves.rows[0][2], 3);
  EXPECT_TRUE(std::isnan(curves.rows[1][2]));
  EXPECT_EQ(curves.rows[1][1], 0.5);
  EXPECT_EQ(curves.rows[2][2], 7);
}

/// No column of the page has another's numbers: every number of a row is one of its own.
TEST_F(RunPage, HasEachColumnOfTheHistoryUnderItsName) {
  const std::vector<std::string> names = history_column_names({"b"}, {"more"});
  {
    HistoryWriter writer(folder_.path.string(), {"b"}, {"more"});
    for (const double at : {0.0, 100.0, 200.0}) {
      HistoryRow row;
      row.step = static_cast<std::int64_t>(at);
      row.time = at + 1;
      row.dt = at + 2;
      row.energy = {.kinetic = at + 3,
                    .internal = at + 4,
                    .hourglass = at + 5,
                    .bulk_viscosity = at + 6,
                    .folding = at + 23,
                    .contact_stored = at + 7,
                    .contact_damped = at + 8,
                    .eroded = at + 9,
                    .external = at + 10,
                    .hourglass_plastic = at + 24};
      row.inside_out = static_cast<std::int64_t>(at) + 25;
      row.balance_error = -(at + 12);
      row.momentum = {at + 13, at + 14, at + 15};
      row.bodies.resize(1);
      row.bodies[0].velocity = {at + 16, at + 17, at + 18};
      row.bodies[0].mass_remaining = at + 19;
      row.bodies[0].eroded_elements = static_cast<std::int64_t>(at) + 20;
      row.bodies[0].max_plastic_strain = at + 21;
      row.more = {at + 22};
      writer.write(row);
    }
  }
  const Json history = block(page(), "history");
  ASSERT_EQ(history["columns"], names);
  const auto expect = [&](const std::string& name, double first) {
    const auto column = static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    ASSERT_LT(column, names.size()) << name;
    const double sign = first < 0 ? -1 : 1;
    EXPECT_EQ(history["data"][column], Json({first, first + sign * 100, first + sign * 200})) << name;
  };
  expect("step", 0);
  expect("folding", 23);
  expect("hourglass_plastic", 24);
  expect("inside_out_elements", 25);
  expect("time", 1);
  expect("dt", 2);
  expect("kinetic", 3);
  expect("internal", 4);
  expect("hourglass", 5);
  expect("bulk_viscosity", 6);
  expect("contact_stored", 7);
  expect("contact_damped", 8);
  expect("eroded", 9);
  expect("external", 10);
  expect("balance_error", -12);
  expect("momentum_x", 13);
  expect("momentum_y", 14);
  expect("momentum_z", 15);
  expect("b_velocity_x", 16);
  expect("b_velocity_y", 17);
  expect("b_velocity_z", 18);
  expect("b_mass_remaining", 19);
  expect("b_eroded_elements", 20);
  expect("b_max_plastic_strain", 21);
  expect("more", 22);
}

TEST_F(RunPage, TellsTheErrorAndTheCommand) {
  const SceneSource source{"my scenes/a'b.toml", "title = \"</script>\"", {{"time.end=2"}, 2, Precision::float32, {}}};
  const std::string text = page({"element 7 <has> no volume", &source});
  EXPECT_THAT(text, HasSubstr("role=\"alert\">element 7 &lt;has&gt; no volume</p>"));
  EXPECT_THAT(text, HasSubstr("id=\"status\">failed<"));
  const Json told = block(text, "scene");
  EXPECT_EQ(told["text"], "title = \"</script>\"");
  EXPECT_THAT(told["command"].get<std::string>(),
              testing::StartsWith("pinball run 'my scenes/a'\\''b.toml' --set time.end=2 --refine 2 --precision"));
}

TEST_F(RunPage, CommandOfADeckNamesTheDeck) {
  auto given = std::make_shared<GivenScene>();
  given->file = "a deck.k";
  given->options = {"--case", "2", "--lenient"};
  const SceneSource source{"decks/a deck.k as a scene", "", {{"time.end=2"}, 1, {}, {}}, given};
  EXPECT_THAT(block(page({"", &source}), "scene")["command"].get<std::string>(),
              testing::StartsWith("pinball run 'decks/a deck.k' --case 2 --lenient --set time.end=2 "));
}

TEST_F(RunPage, ThatCannotBeWrittenIsAnError) {
  EXPECT_THROW(write_run_page("/dev/null/folder", scene(), {}, {}), RunError);
}

}  // namespace
}  // namespace pinball::page_test
