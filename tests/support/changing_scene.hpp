#pragma once

#include <string>

namespace pinball::test {

/// A scene with every key that has a start, an end or a table of times, each of them within the run, several of them at
/// once and one after the other; in units of m, kg and s.
inline const std::string changing_scene = R"(units = "kg-m-s"
title = "What begins, ends and follows a table"
[time]
end = 6e-4
[[material]]
name = "steel"
model = "von_mises"
density = 7850
young_modulus = 2.1e11
poisson_ratio = 0.3
yield_stress = 4e8
plastic_modulus = 1e9

[[body]]
name = "lower"
material = "steel"
velocity = [0, 0, -20]
mesh = { type = "block", size = [0.6, 0.5, 0.5], elements = [6, 5, 5] }
[[body]]
name = "upper"
material = "steel"
position = [0.1, 0, 0.5005]
velocity = [3, 0, -60]
mesh = { type = "block", size = [0.4, 0.5, 0.3], elements = [4, 5, 3] }
[[body]]
name = "rider"
material = "steel"
position = [0.1, 0.05, 0.8005]
velocity = [0, 2, -60]
mesh = { type = "block", size = [0.4, 0.4, 0.2], elements = [6, 6, 2] }
[[body]]
name = "alone"
material = "steel"
position = [2, 0, 0.01]
velocity = [0, 0, -30]
mesh = { type = "block", size = [0.3, 0.3, 0.3], elements = [3, 3, 3] }

[contact]
method = "pinball"
enforcement = "lagrange"
gap = "face"
[[contact.pair]]
name = "blow"
first = "lower"
second = "upper"
friction = 0.1
static_friction = 0.2
start = 1e-5
end = 5.2e-4
[[contact.pair]]
name = "late"
first = "upper"
second = "rider"
start = 4.1e-4
[[contact.tied]]
name = "glue"
first = "rider"
second = "upper"
tolerance = 0.005
start = 6e-5
end = 4e-4

[[constraint]]
type = "symmetry"
normal = [0, 1, 0]
[[constraint]]
type = "fixed"
name = "grip"
body = "alone"
plane = { point = [2, 0, 0], normal = [1, 0, 0] }
directions = ["x", [0, 0.6, 0.8]]
start = 1.2e-4
end = 3.1e-4
[[constraint]]
type = "fixed"
body = "alone"
box = { low = [2.1, 0, 0.2], high = [2.3, 0.3, 0.4] }
directions = "all"
start = 3.5e-4
[[constraint]]
type = "fixed"
body = "lower"
plane = { point = [0.6, 0, 0], normal = [1, 0, 0] }
directions = ["x"]
end = 2.2e-4

[[rigid_wall]]
name = "floor"
normal = [0, 0, 1]
friction = 0.3
end = 4.8e-4
[[rigid_wall]]
name = "ram"
point = [0, 0, 0]
normal = [1, 0, 0]
body = "lower"
speed = 15
times = [0, 1e-4, 3e-4]
factors = [0, 1, -0.5]
start = 2e-5
[[rigid_wall]]
name = "anvil"
point = [2, 0, 0]
normal = [0, 0, 1]
body = "alone"
mass = 30
start = 0
end = 2.9e-4

[[prescribed_velocity]]
name = "push"
body = "rider"
plane = { point = [0, 0, 1.0005], normal = [0, 0, 1] }
direction = [0, 0.6, -0.8]
speed = 40
times = [0, 2e-4, 4e-4]
factors = [1, 2, 0.5]
start = 9e-5
end = 2.6e-4
[[prescribed_velocity]]
body = "alone"
plane = { point = [0, 0, 0.31], normal = [0, 0, 1] }
direction = [0, 0, 1]
speed = -2e-3
quantity = "displacement"
times = [0, 1e-4, 6e-4]
factors = [0, 1, 3]
end = 1.7e-4
[[prescribed_velocity]]
body = "lower"
line = { point = [0.6, 0, 0], direction = [0, 1, 0] }
direction = [0, 0, 1]
speed = 2e5
quantity = "acceleration"
times = [0, 1e-4, 6e-4]
factors = [0, 1, -1]
start = 2.4e-4
end = 5.6e-4

[[load]]
body = "lower"
force = [2e6, 3e5, 0]
times = [5e-5, 1.5e-4, 4e-4]
factors = [0, 1, -2]
[[pressure]]
name = "gas"
body = "rider"
plane = { point = [0.5, 0, 0], normal = [1, 0, 0] }
pressure = 3e7
times = [0, 1e-4, 3e-4]
factors = [0, 1, 0.2]
start = 7e-5
[[gravity]]
acceleration = [0, 0, -4e4]
times = [0, 2e-4, 5e-4]
factors = [1, 0, 2]
[[gravity]]
name = "pull"
bodies = ["alone", "upper"]
acceleration = [5e4, 0, 0]
times = [0, 3e-4]
factors = [0, 1]

[[probe]]
name = "tip"
kind = "node"
point = [2.3, 0.3, 0.31]
[[probe]]
name = "core"
kind = "element"
body = "rider"
point = [0.3, 0.25, 0.9]
[output]
interval = 1e-5
field_times = [1e-4, 4.3e-4]
body_energies = true
)";

}  // namespace pinball::test
