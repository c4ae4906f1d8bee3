# SPDX-License-Identifier: GPL-3.0-or-later
#
# Recipe for Spack, of sources that are here:
#
#     spack repo create here graincrack
#     install -D share/packaging/spack/package.py here/packages/graincrack/package.py
#     spack repo add here
#     spack dev-build --source-path . graincrack@0.1.0
#
# Pictures use the font Liberation Sans of the system.
from spack.package import *

try:
    from spack_repo.builtin.build_systems.cmake import CMakePackage
except ImportError:  # before version 1.0 of Spack it came with spack.package
    pass


class Graincrack(CMakePackage):
    """Computes how crystalline rock breaks, grain by grain: three programs mesh assemblages of
    elastic crystals, break them by the discrete element method, and evaluate strengths, moduli
    and crack maps."""

    license("GPL-3.0-or-later")

    version("0.1.0")

    variant("mpi", default=False, description="Runs of graincrack-solve on many ranks")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("gzip", type="build")
    depends_on("python@3.9:", type=("build", "run"))
    depends_on("py-h5py", type="run")
    depends_on("py-numpy", type="run")

    depends_on("cairo+ft+fc+png+pdf+svg")
    depends_on("cgal@5.5:")
    depends_on("cli11@2.1:")
    depends_on("eigen@3.4:3")
    depends_on("fmt@9:")
    depends_on("gsl")
    depends_on("hdf5@1.10:")
    depends_on("hdf5~mpi", when="~mpi")
    depends_on("libpng")
    depends_on("mpi", when="+mpi")
    depends_on("nlohmann-json")
    depends_on("openssl@3:")
    depends_on("pango")
    depends_on("sqlite")
    depends_on("tomlplusplus@3.3:")
    depends_on("vtk@9.1:")
    depends_on("vtk~mpi", when="~mpi")
    depends_on("zlib-api")

    conflicts("%gcc@:11", msg="C++20 as of GCC 12")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("GRAINCRACK_TESTS", False),
            self.define_from_variant("GRAINCRACK_MPI", "mpi"),
            self.define("CMAKE_UNITY_BUILD", True),
        ]

    def setup_run_environment(self, env):
        env.prepend_path("PYTHONPATH", self.prefix.lib.python3.join("dist-packages"))

    def test_disc(self):
        """a small disc is meshed, broken and measured"""
        mesh = which(self.prefix.bin.join("graincrack-mesh"))
        solve = which(self.prefix.bin.join("graincrack-solve"))
        post = which(self.prefix.bin.join("graincrack-post"))
        material = ["--material", "augig-granite-triangles"]
        mesh("disc", "--diameter", "25mm", "--edge", "4mm", *material, "-o", "disc.h5")
        solve("brazilian", "disc.h5", *material, "-o", "run.h5")
        assert "run.h5" in post("strength", "run.h5", output=str)
