# Use: make a repository of recipes (spack repo create), copy this file to packages/pinball/package.py in it.
from spack.package import *


class Pinball(CMakePackage):
    """Explicit dynamics of solids in contact and impact around the pinball algorithm of Belytschko, Liu and Neal (1990),
    and its contact by itself, for C, C++ and Fortran codes that have their own mesh and time loop."""

    license("MIT")

    # No release has been published yet: in a checkout, `spack develop --path FOLDER pinball@main`.
    version("main", branch="main")

    variant("shared", default=True, description="Shared libraries in place of archives")
    variant("solver", default=True, description="The solver and the program, besides the contact library")
    variant("python", default=False, when="+solver", description="The Python module")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("fmt@9:", when="+solver")
    depends_on("cli11@2:", when="+solver", type="build")
    depends_on("nlohmann-json@3.11:", when="+solver", type="build")
    depends_on("eigen@3.4:", when="+solver", type="build")
    depends_on("tomlplusplus@3.3:", when="+solver")
    depends_on("pkgconfig", when="+solver", type=("build", "link"))
    # For meshes of Exodus and VTK.
    depends_on("netcdf-c", when="+solver")
    depends_on("pugixml", when="+solver")
    depends_on("zlib-api", when="+solver")

    depends_on("py-pybind11@2.10:", when="+python", type="build")
    depends_on("py-numpy", when="+python", type=("build", "run"))
    extends("python@3.9:", when="+python")

    # Packs of lanes are those of std::experimental::simd, which comes with GCC's library.
    conflicts("%gcc@:11")
    conflicts("platform=darwin", msg="needs std::experimental::simd")

    def cmake_args(self):
        # Spack's compiler wrappers set the instruction set of the target.
        arguments = [
            self.define_from_variant("BUILD_SHARED_LIBS", "shared"),
            self.define_from_variant("PINBALL_SOLVER", "solver"),
            self.define("PINBALL_PYTHON", "+python" in self.spec),
            self.define("PINBALL_NATIVE", False),
            self.define("PINBALL_TESTS", False),
            self.define("PINBALL_BENCH", False),
        ]
        if "+python" in self.spec:
            arguments.append(self.define("Python_EXECUTABLE", self.spec["python"].command.path))
        return arguments
