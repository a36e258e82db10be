# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the library of the Python package by CMake; pyproject.toml has the rest.

What CMake needs is in the README: a C++ compiler, Eigen, Boost, GSL and FFTW. Environment variables:
CMAKE_ARGS has options for it, CMAKE_BUILD_PARALLEL_LEVEL says how many compilers run at once, and
MICROSLIP_BUILD_FOLDER names a build folder that has been configured, which is used then.
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


def version():
    """That of the CMake project, the only place that has it."""
    text = (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(microslip VERSION (\S+)", text).group(1)


class BuildLibrary(build_ext):
    """The library is loaded by ctypes, so that it has no name of an extension module."""

    def get_ext_filename(self, fullname):
        return os.path.join(*fullname.split(".")) + ".so"

    def build_extension(self, ext):
        given = os.environ.get("MICROSLIP_BUILD_FOLDER")
        build = pathlib.Path(given or self.build_temp).resolve() / ("" if given else "cmake")
        cores = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(len(os.sched_getaffinity(0)))
        if not given:
            subprocess.run(["cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF",
                            *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "microslip_python", "--parallel", cores], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(build / "python/microslip/_microslip.so", target)


class AnyPython(bdist_wheel):
    """A wheel for this machine, and any Python 3."""

    def get_tag(self):
        return "py3", "none", super().get_tag()[2]


setup(version=version(), ext_modules=[Extension("microslip._microslip", sources=[])],
      cmdclass={"build_ext": BuildLibrary, "bdist_wheel": AnyPython})
