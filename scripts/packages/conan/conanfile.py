"""The library for Conan 2, from the clone that this file lies in: conan create scripts/packages/conan."""

import pathlib
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

PARTS = ["geometry", "clipping", "methods", "kernel", "afresh", "scene"]
STATIC_PARTS = ["geometry", "kernel", "afresh", "scene"]
BENEATH = {"clipping": "geometry", "methods": "clipping", "kernel": "clipping", "afresh": "kernel", "scene": "afresh"}


class Manifuzz(ConanFile):
    name = "manifuzz"
    description = "Contact points of convex shapes by clipping"
    license = "MIT"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"system": [True, False]}
    default_options = {"system": False}
    options_description = {"system": "take Eigen and Highway from this machine, not from Conan's server"}

    def _clone(self):
        return pathlib.Path(self.recipe_folder).parents[2]

    def set_version(self):
        text = load(self, str(self._clone() / "CMakeLists.txt"))
        self.version = re.search(r"project\(manifuzz VERSION ([0-9.]+)", text).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "src/*"):
            copy(self, pattern, str(self._clone()), self.export_sources_folder)

    def requirements(self):
        if not self.options.system:
            self.requires("eigen/3.4.0", transitive_headers=True)
            self.requires("highway/1.0.3")

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.variables["MANIFUZZ_HARNESS"] = False
        toolchain.generate()
        if not self.options.system:
            from conan.tools.cmake import CMakeDeps
            dependencies = CMakeDeps(self)
            dependencies.set_property("highway", "cmake_file_name", "hwy")
            dependencies.set_property("highway::hwy", "cmake_target_name", "hwy::hwy")
            dependencies.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # The package's own CMake files, which know options that headers need.
        self.cpp_info.set_property("cmake_find_mode", "none")
        for part in PARTS:
            component = self.cpp_info.components[part]
            component.builddirs = ["lib/cmake/manifuzz"]
            component.set_property("pkg_config_name", f"manifuzz-{part}")
            component.libs = [f"manifuzz_{part}"] if part in STATIC_PARTS else []
            if part in BENEATH:
                component.requires = [BENEATH[part]]
            else:
                component.cxxflags = ["-ffp-contract=off"]
                component.requires = [] if self.options.system else ["eigen::eigen", "highway::hwy"]
