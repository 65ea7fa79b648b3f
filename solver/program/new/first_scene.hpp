#pragma once

/// What `pinball new` writes: NAME stands for the name of the scene.
namespace pinball {

inline constexpr const char* first_scene = R"(# A first scene: a ball of steel strikes a plate of aluminium at 150 m/s.
#
#   pinball info NAME.toml      what is in it, what will run, how long that takes
#   pinball run NAME.toml       runs it; results are in out/NAME
#
# What stands here is a beginning: change it. All keys with their units and defaults: data/scenes/README.md, or
# share/pinball/data/scenes/README.md where the program is installed. A key that is not known is an error that names
# the nearest one; what is not named has a default.

title = "A steel ball strikes an aluminium plate"
# Units are any consistent set; nothing is converted. Here mass in g, length in mm, time in ms: then velocity is in m/s,
# stress in MPa, force in N, energy in mJ. In m, kg and s write "kg-m-s", and all numbers in SI.
units = "g-mm-ms"
precision = "double"           # or "mixed": faster, elements less exact; "float": half the memory, less exact

[time]
end = 0.06                     # when the run stops [ms]
cfl = 0.9                      # fraction of the largest stable step, up to which steps are made [-]

[contact]
method = "pinball"             # bodies meet; "none": they pass through each other
friction = 0.2                 # Coulomb's coefficient [-]

[output]
interval = 3e-4                # between rows of history.csv [ms]
field_interval = 0.01          # between files for ParaView, out/NAME/fields.pvd [ms]

# As many materials as you like; bodies name them.
[[material]]
name = "steel"
model = "elastic"
density = 7.85e-3              # [g/mm^3]
young_modulus = 2.1e5          # [MPa]; or bulk_modulus and shear_modulus
poisson_ratio = 0.3            # [-]

[[material]]
name = "aluminium"
model = "von_mises"            # elastic and plastic
density = 2.7e-3
young_modulus = 7.0e4
poisson_ratio = 0.33
yield_stress = 150.0           # [MPa]
plastic_modulus = 300.0        # slope of the yield stress over plastic strain [MPa]
# erosion_strain = 1.5         # elements that reach this plastic strain are taken out [-]; else none is

[[body]]
name = "ball"
material = "steel"
mesh = { type = "sphere", radius = 4.0, core = 4, ring = 3 }    # centre at the origin of the body [mm]
position = [0.0, 0.0, 4.05]    # moves the mesh [mm]
velocity = [20.0, 0.0, -150.0] # at the start [mm/ms, which is m/s]

[[body]]
name = "plate"
material = "aluminium"
mesh = { type = "block", size = [30.0, 30.0, 3.0], elements = [24, 24, 3] }    # a corner at the origin of the body
position = [-15.0, -15.0, -3.0]

# Held are the nodes on two edges of the plate; plane, line, box, body and nearest choose nodes.
[[constraint]]
type = "fixed"
directions = "all"
body = "plate"
plane = { point = [-15.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] }

[[constraint]]
type = "fixed"
directions = "all"
body = "plate"
plane = { point = [15.0, 0.0, 0.0], normal = [1.0, 0.0, 0.0] }

# The history of a node or an element gets columns of its own in history.csv.
[[probe]]
name = "below"
kind = "node"
point = [0.0, 0.0, -3.0]       # the node nearest to it [mm]
quantities = ["displacement", "velocity"]
)";

}  // namespace pinball
