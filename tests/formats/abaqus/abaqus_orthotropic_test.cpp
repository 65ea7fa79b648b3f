#include <gmock/gmock.h>

#include <solver/scene/material/orthotropic_moduli.hpp>

#include "abaqus_case.hpp"

/// *ELASTIC of several types, and *ORIENTATION.
namespace pinball::test::abaqus_orthotropic_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

class AbaqusOrthotropic : public AbaqusTest {
 protected:
  /// A cube of a material with these constants; section: parameters of its section; more: keywords of its part.
  static std::string deck(const std::string& elastic, const std::string& section = "", const std::string& more = "",
                          const std::string& instance = "") {
    std::string cube = abaqus_cube;
    const std::string end = "MATERIAL=Steel";
    cube.replace(cube.find(end), end.size(), end + section);
    return "*PART, NAME=Cube\n" + cube + more + "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=One, PART=Cube\n" +
           instance + "*END INSTANCE\n*END ASSEMBLY\n*MATERIAL, NAME=Steel\n*DENSITY\n7.85E-9\n*ELASTIC" + elastic +
           abaqus_step();
  }
  static OrthotropicSettings law(const Scene& scene) { return *scene.materials.at(0).orthotropic; }
};

const std::string constants = ", TYPE=ENGINEERING CONSTANTS\n9000., 5000., 2000., 0.3, 0.2, 0.1, 700., 500.,\n300.\n";

TEST_F(AbaqusOrthotropic, EngineeringConstantsAreThoseOfTheScene) {
  const OrthotropicSettings made = law(scene(deck(constants)));
  EXPECT_EQ(made, (OrthotropicSettings{{9000, 5000, 2000}, {0.3, 0.2, 0.1}, {700, 500, 300}}));
  EXPECT_THAT(error(deck(", TYPE=ENGINEERING CONSTANTS\n9000., 5000., 2000., 0.3, 0.2, 0.1, 700., 500.\n")),
              HasSubstr("expected the ninth constant"));
  EXPECT_THAT(error(deck(", TYPE=ENGINEERING CONSTANTS\n9000., 5000., 2000., 1.4, 0.2, 0.1, 700., 500.,\n300.\n")),
              HasSubstr("poisson_ratios"));
  EXPECT_THAT(error(deck(constants + "9., 5., 2., 0.3, 0.2, 0.1, 7., 5.\n3., 400.\n")),
              HasSubstr("depends on temperature"));
  EXPECT_THAT(error(deck(constants + "*PLASTIC\n5.\n")), HasSubstr("what yields is isotropic"));
}

/// Those of an own deck of CalculiX' kind: the moduli of the scene are the given ones again.
TEST_F(AbaqusOrthotropic, ModuliBecomeEngineeringConstants) {
  for (const char* type : {"ORTHO", "ORTHOTROPIC"}) {
    const ElasticMatrix c = moduli_along_axes(law(
        scene(deck(std::string(", TYPE=") + type + "\n500., 150., 400., 120., 90., 300., 130., 110.,\n80., 294.\n"))));
    const double upper[6] = {500, 150, 400, 120, 90, 300};
    for (std::size_t i = 0, k = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) EXPECT_NEAR(c[i][j], upper[k++], 1e-10) << i << j;
    }
    EXPECT_EQ(c[3][3], 130);
    EXPECT_EQ(c[4][4], 80);
    EXPECT_EQ(c[5][5], 110);
  }
  EXPECT_THAT(error(deck(", TYPE=ORTHO\n500., 500., 400., 120., 90., 300., 130., 110.,\n80.\n")),
              HasSubstr("expected moduli with which every strain has an energy"));
}

TEST_F(AbaqusOrthotropic, AxesAreThoseOfTheSection) {
  const std::string turned = "*ORIENTATION, NAME=Ori\n0., 2., 0., -1., 1., 0.\n3, 0.\n";
  const OrthotropicSettings made = law(scene(deck(constants, ", ORIENTATION=Ori", turned)));
  EXPECT_EQ(made.first_axis, (Point{0, 2, 0}));
  EXPECT_EQ(made.second_axis, (Point{-1, 1, 0}));
  const OrthotropicSettings with_instance =
      law(scene(deck(constants, ", ORIENTATION=Ori", turned, "5., 6., 7.\n0., 0., 0., 0., 0., 1., 90.\n")));
  EXPECT_NEAR(with_instance.first_axis[0], -2, 1e-12) << "which turns y to -x";
  EXPECT_NEAR(with_instance.first_axis[1], 0, 1e-12);
  EXPECT_THAT(error(deck(constants, ", ORIENTATION=Other", turned)), HasSubstr("there is no *ORIENTATION Other"));
  EXPECT_THAT(
      error(deck(constants, ", ORIENTATION=Ori", "*ORIENTATION, NAME=Ori, SYSTEM=CYLINDRICAL\n0.,0.,0.,0.,0.,1.\n")),
      HasSubstr("*ORIENTATION, SYSTEM=CYLINDRICAL"));
  EXPECT_THAT(error(deck(constants, ", ORIENTATION=Ori", "*ORIENTATION, NAME=Ori\n1.,0.,0.,0.,1.,0.\n3, 30.\n")),
              HasSubstr("*ORIENTATION with a further rotation"));
}

/// Of an isotropic material any system says nothing.
TEST_F(AbaqusOrthotropic, AxesOfWhatIsIsotropicAreNotUsed) {
  const std::string round = "*ORIENTATION, NAME=Ori, SYSTEM=CYLINDRICAL\n0.,0.,0.,0.,0.,1.\n";
  EXPECT_THAT(translate(deck("\n210000., 0.3\n", ", ORIENTATION=Ori", round)).understood,
              Contains(HasSubstr("not used: *ORIENTATION")));
}

}  // namespace
}  // namespace pinball::test::abaqus_orthotropic_test
