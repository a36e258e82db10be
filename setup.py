# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the library of the Python package by CMake; pyproject.toml has the rest.

What CMake needs is in the README: a C++ compiler, Eigen, Boost, fmt, GSL and FFTW. Environment variables:
CMAKE_ARGS has options for it, CMAKE_BUILD_PARALLEL_LEVEL says how many compilers run at once,
MICROSLIP_BUILD_FOLDER names a build folder that has been configured, which is used then, and with MICROSLIP_BUNDLE=1
the wheel has the shared libraries inside that the library needs, but for those of the C and C++ runtime.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from wheel.bdist_wheel import bdist_wheel

SOURCE = pathlib.Path(__file__).resolve().parent
BUNDLE = os.environ.get("MICROSLIP_BUNDLE") == "1"
# A glibc has them, and a C++ compiler of its time the others; so no wheel brings them.
RUNTIME = re.compile(r"linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+)\.so")


def version():
    """That of the CMake project, the only place that has it."""
    text = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(microslip VERSION (\S+)", text).group(1)


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout


def bundle(library):
    """Copies what a library needs into libs/ beside it, where its RPATH leads."""
    folder = library.parent / "libs"
    folder.mkdir(exist_ok=True)
    for name, path in re.findall(r"^\s*(\S+) => (.*?)(?: \(0x\w+\))?$", output_of("ldd", library), re.MULTILINE):
        if RUNTIME.match(name):
            continue
        if not pathlib.Path(path).is_file():
            raise SystemExit(f"{name}: expected a library that is installed, not '{path}'")
        shutil.copyfile(path, folder / name)


def platform_of(libraries, built):
    """Replaces linux by manylinux_2_N, where N is the least minor version of glibc that has all symbols, so that pip
    refuses a wheel that would not load."""
    minors = [int(minor) for library in libraries
              for minor in re.findall(r"\bGLIBC_2\.(\d+)", output_of("objdump", "-T", library))]
    return re.sub("^linux_", f"manylinux_2_{max(minors)}_", built) if minors else built


class BuildLibrary(build_ext):
    """The library is loaded by ctypes, so that it has no name of an extension module."""

    def get_ext_filename(self, fullname):
        return os.path.join(*fullname.split(".")) + ".so"

    def build_extension(self, ext):
        given = os.environ.get("MICROSLIP_BUILD_FOLDER")
        build = pathlib.Path(given or self.build_temp).resolve() / ("" if given else "cmake")
        cores = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(len(os.sched_getaffinity(0)))
        if not given:
            options = shlex.split(os.environ.get("CMAKE_ARGS", ""))
            is_new = not (build / "CMakeCache.txt").exists()
            if is_new and "CMAKE_GENERATOR" not in os.environ and shutil.which("ninja"):
                options = ["-G", "Ninja", *options]  # keeps all cores busy, which make does not between targets
            subprocess.run(["cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
                            "-DMICROSLIP_ONLY_PYTHON=ON", *options], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "microslip_python", "--parallel", cores], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(build / "python/microslip/_microslip.so", target)
        shutil.copyfile(SOURCE / "tables/creep_forces.nc", target.with_name("creep_forces.nc"))
        if BUNDLE:
            bundle(target)


class AnyPython(bdist_wheel):
    """A wheel for this machine, and any Python 3; with its libraries inside, for others with the same glibc, too."""

    def get_tag(self):
        built = super().get_tag()[2]
        if BUNDLE:
            folder = pathlib.Path(self.get_finalized_command("build").build_lib) / "microslip"
            built = platform_of([folder / "_microslip.so", *folder.glob("libs/*")], built)
        return "py3", "none", built


setup(version=version(), ext_modules=[Extension("microslip._microslip", sources=[])],
      cmdclass={"build_ext": BuildLibrary, "bdist_wheel": AnyPython})
