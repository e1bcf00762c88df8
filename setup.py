"""The Python package ligne from the source tree, for pip: CMake builds its compiled part. docs/python.md says what it needs."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).parent.resolve()


class CMakeBuild(build_ext):
    """Builds python/ with CMake, for the interpreter that pip runs in."""

    def build_extension(self, extension):
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve().parent
        build = pathlib.Path(self.build_temp).resolve()
        options = [
            "-DCMAKE_BUILD_TYPE=Release",
            "-DLIGNE_UNITY=ON",
            "-DLIGNE_PYTHON=ON",
            "-DLIGNE_PROGRAM=OFF",
            "-DLIGNE_INSTALL=OFF",
            f"-DPython_EXECUTABLE={sys.executable}",
            f"-DLIGNE_PYTHON_MODULE_FOLDER={target}",
        ]
        if shutil.which("ninja"):
            options += ["-G", "Ninja"]
        try:
            import pybind11

            options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:
            pass  # the system's
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *options], check=True)
        jobs = str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", str(build), "--target", "ligne_python", "--parallel", jobs], check=True)


version = re.search(r"project\(ligne VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("ligne._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
