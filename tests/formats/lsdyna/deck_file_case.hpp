#pragma once

#include <solver/formats/lsdyna/cards/keyword_scene.hpp>
#include <solver/model/model.hpp>
#include <solver/scene.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/folder_case.hpp>

/// Decks of a few lines, of any program, written to a file of their own.
namespace pinball::test {

class DeckFileTest : public FolderTest {
 protected:
  explicit DeckFileTest(std::string file_name) : file_name_(std::move(file_name)) {}
  void SetUp() override {
    FolderTest::SetUp();
    path_ = (folder_ / file_name_).string();
  }

  /// What the deck becomes; it is left at path_.
  virtual TranslatedDeck translate(const std::string& text, const DeckOptions& options) = 0;
  TranslatedDeck translate(const std::string& text) { return translate(text, DeckOptions{}); }

  Scene scene(const std::string& text, const DeckOptions& options = {}) {
    return read_scene(translate(text, options).source(path_));
  }
  /// The text of the error without the folder; no_error if there is none.
  std::string error(const std::string& text, const DeckOptions& options = {}) {
    return without_folder(error_of([&] { scene(text, options); }));
  }
  std::string without_folder(std::string message) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix))
      message.erase(at, prefix.size());
    return message;
  }

  std::string path_;

 private:
  std::string file_name_;
};

/// The scene of one cube of 1 mm of steel, with density 7.85e-9, Young's modulus 210000 and Poisson's ratio 0.3, that
/// has the title "A cube" and ends at 1e-6.
inline void expect_cube(const Scene& scene, const std::string& body) {
  EXPECT_EQ(scene.title, "A cube");
  EXPECT_EQ(scene.time.end, 1e-6);
  EXPECT_EQ(scene.bodies.at(0).name, body);
  EXPECT_EQ(scene.materials.at(0).density, 7.85e-9);
  EXPECT_DOUBLE_EQ(scene.materials.at(0).shear_modulus, 210000. / 2.6);
  EXPECT_EQ(scene.contact.method, ContactMethod::none);
  const Model<double> model = build_model<double>(scene);
  EXPECT_EQ(model.element_count(), 1);
  EXPECT_DOUBLE_EQ(model.element_mass[0], 7.85e-9);
}

}  // namespace pinball::test
