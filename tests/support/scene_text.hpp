#pragma once

#include <gtest/gtest.h>

#include <string>

/// Files of scenes as text.
namespace pinball::test {

/// Lines 1 to 16 of a scene that runs in no time: a cube alone, of one element. Line 16 is the body's mesh.
inline const std::string cube_scene = R"(units = "kg-m-s"
[time]
end = 1e-4
[element]
bulk_viscosity = false
[[material]]
name = "steel"
model = "elastic"
density = 7850
young_modulus = 2.1e11
poisson_ratio = 0.3
[[body]]
name = "cube"
material = "steel"
velocity_noise = 1.0
mesh = { type = "block", size = [0.1, 0.1, 0.1], elements = [1, 1, 1] }
)";

/// A text with one place of it replaced, which it must have.
inline std::string replaced(std::string text, const std::string& what, const std::string& instead) {
  const auto place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return place == std::string::npos ? text : text.replace(place, what.size(), instead);
}

}  // namespace pinball::test
