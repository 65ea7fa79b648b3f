#include <gmock/gmock.h>

#include <solver/scene_rules.hpp>
#include <tests/support/scene_fixture.hpp>

/// Reading of what touches what.
namespace pinball::scene_contact_test {
namespace {

using namespace test;
using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> touching{"[contact]", "method = \"pinball\"", "friction = 0.3", "friction_decay = 7"};

class SceneContactTest : public SceneTest {
 protected:
  /// Lines after the contact settings.
  static std::vector<std::string> pairs(const std::vector<std::string>& more) {
    std::vector<std::string> lines = touching;
    lines.insert(lines.end(), more.begin(), more.end());
    return with(lines);
  }
};

TEST_F(SceneContactTest, Friction) {
  const Scene scene = read(with({"[contact]", "method = \"pinball\"", "enforcement = \"lagrange\"", "friction = 0.3"}));
  EXPECT_EQ(scene.contact.friction, 0.3);
  EXPECT_EQ(scene.contact.static_friction, 0.3);
  EXPECT_EQ(error(with({"[contact]", "enforcement = \"penalty\"", "friction = 0.3"})),
            "17:12: contact.friction: expected 0: friction needs enforcement = \"projection\" or \"lagrange\"");
  const auto with_friction = [this](const std::string& enforcement, const std::string& at_rest) {
    return error(
        with({"[contact]", "enforcement = \"" + enforcement + "\"", "friction = 0.3", "static_friction = " + at_rest}));
  };
  EXPECT_EQ(with_friction("lagrange", "0.5"), "no error");
  EXPECT_EQ(with_friction("lagrange", "0.2"),
            "18:19: contact.static_friction: expected a number >= friction = 0.3, got 0.2");
  EXPECT_EQ(with_friction("projection", "0.5"),
            "18:19: contact.static_friction: another value than friction needs enforcement = \"lagrange\"");
}

TEST_F(SceneContactTest, ReadsEveryKeyOfAPair) {
  const Scene scene = read(pairs({R"([[contact.pair]]
name = "one"
first = ["bar", { elements = "12" }]
second = { faces = "top", file = "a.k" }
friction = 0.1
static_friction = 0.2
friction_decay = 3
start = 0.25
end = 0.5
[[contact.pair]]
first = "bar")"}));
  ASSERT_EQ(scene.contact_pairs.size(), 2u);
  const ContactPair& one = scene.contact_pairs[0];
  EXPECT_EQ(one.name, "one");
  EXPECT_THAT(one.first.bodies, ElementsAre("bar"));
  EXPECT_EQ(one.first.elements.at(0).set, "12");
  EXPECT_EQ(one.second.faces.at(0).set, "top");
  EXPECT_EQ(one.second.faces.at(0).file, "a.k");
  EXPECT_EQ(one.friction, 0.1);
  EXPECT_EQ(one.static_friction, 0.2);
  EXPECT_EQ(one.friction_decay, 3);
  EXPECT_EQ(one.start, 0.25);
  EXPECT_EQ(one.end, 0.5);
  const ContactPair& two = scene.contact_pairs[1];
  EXPECT_EQ(two.name, "pair_1");
  EXPECT_TRUE(two.second.empty());
  EXPECT_EQ(two.friction, 0.3) << "that of [contact]";
  EXPECT_EQ(two.friction_decay, 7);
  EXPECT_EQ(two.end, never);
}

TEST_F(SceneContactTest, APairWithFrictionOfItsOwnTakesNoneOfContact) {
  const Scene scene = read(pairs({"[[contact.pair]]", "first = \"bar\"", "friction = 0"}));
  EXPECT_EQ(scene.contact_pairs.at(0).static_friction, 0);
  EXPECT_EQ(scene.contact_pairs[0].friction_decay, 0);
}

TEST_F(SceneContactTest, KeysOfPairsAreSetByNumber) {
  SceneOverrides overrides;
  overrides.set = {"contact.pair.0.friction=0.7"};
  EXPECT_EQ(read(pairs({"[[contact.pair]]", "first = \"bar\""}), overrides).contact_pairs.at(0).friction, 0.7);
  overrides.set = {"contact.pair.1.friction=0.7"};
  EXPECT_THROW(read(pairs({"[[contact.pair]]", "first = \"bar\""}), overrides), InputError);
}

TEST_F(SceneContactTest, BadPairsAreNamed) {
  const auto problem = [this](const std::vector<std::string>& lines) {
    std::vector<std::string> more{"[[contact.pair]]"};
    more.insert(more.end(), lines.begin(), lines.end());
    return error(pairs(more));
  };
  EXPECT_EQ(problem({"first = [\"bat\"]"}), "20:9: contact.pair.0.first: no body is named \"bat\", nearest is \"bar\"");
  EXPECT_THAT(problem({}), HasSubstr("contact.pair.0.first: missing, expected names of bodies"));
  EXPECT_THAT(problem({"first = [4]"}), HasSubstr("20:10: contact.pair.0.first[0]: expected names of bodies"));
  EXPECT_THAT(problem({"first = { elements = \"1\", faces = \"2\" }"}), HasSubstr("expected names of bodies"));
  EXPECT_THAT(problem({"first = { nodes = \"1\" }"}), HasSubstr("contact.pair.0.second: missing: a set of nodes"));
  EXPECT_THAT(problem({"first = \"bar\"", "start = 2", "end = 1"}),
              HasSubstr("22:7: contact.pair.0.end: expected a time after start = 2, got 1"));
  EXPECT_THAT(problem({"first = \"bar\"", "friction = 0.2", "static_friction = 0.1"}),
              HasSubstr("contact.pair.0.static_friction: expected a number >= friction = 0.2, got 0.1"));
  EXPECT_THAT(problem({"first = \"bar\"", "name = \"bar_contact\""}), HasSubstr("the names of those of a body"));
  EXPECT_THAT(problem({"first = \"bar\"", "[[contact.pair]]", "name = \"pair_0\"", "first = \"bar\""}),
              HasSubstr("a second time"));
  EXPECT_THAT(error(with({"[contact]", "method = \"none\"", "[[contact.pair]]", "first = \"bar\""})),
              HasSubstr("a pair needs contact.method"));
  Scene left_out = read(with({"[[contact.pair]]", "first = \"bar\""}));
  complete_scene(left_out);
  EXPECT_EQ(left_out.contact.method, ContactMethod::pinball);
}

TEST_F(SceneContactTest, ReadsEveryKeyOfATie) {
  const Scene scene = read(with({R"([[contact.tied]]
name = "glue"
first = { nodes = "3" }
second = "bar"
tolerance = 0.5
start = 0.25
end = 0.75
[[contact.tied]]
first = "bar"
second = { faces = "4" })"}));
  ASSERT_EQ(scene.tied_contacts.size(), 2u);
  const TiedContact& glue = scene.tied_contacts[0];
  EXPECT_EQ(glue.name, "glue");
  EXPECT_EQ(glue.first.nodes.at(0).set, "3");
  EXPECT_THAT(glue.second.bodies, ElementsAre("bar"));
  EXPECT_EQ(glue.tolerance, 0.5);
  EXPECT_EQ(glue.start, 0.25);
  EXPECT_EQ(glue.end, 0.75);
  EXPECT_EQ(scene.tied_contacts[1].name, "tied_1");
  EXPECT_LT(scene.tied_contacts[1].tolerance, 0) << "by the size of faces";
  EXPECT_THAT(error(with({"[[contact.tied]]", "first = \"bar\""})),
              HasSubstr("contact.tied.0.second: missing, expected names of bodies"));
  EXPECT_THAT(error(with({"[[contact.tied]]", "first = \"bar\"", "second = { nodes = \"4\" }"})),
              HasSubstr("contact.tied.0.second: expected faces to tie to"));
  EXPECT_THAT(error(with({"[[contact.tied]]", "first = \"bar\"", "second = \"bar\"", "tolerance = -1"})),
              HasSubstr("contact.tied.0.tolerance: expected a number >= 0"));
}

}  // namespace
}  // namespace pinball::scene_contact_test
