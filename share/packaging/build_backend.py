"""Build backend (PEP 517) of `pip install .`: CMake builds the programs, which with their files and the Python package become a wheel.

Settings (`pip install . --config-settings NAME=VALUE`):

    build-dir=FOLDER    build there; a folder that is configured stays as it is (build-wheel/ in the sources unless given)
    bundle=yes          shared libraries, fonts and licences of this machine, a Debian, go into the wheel, which then needs glibc alone

$CMAKE_ARGS are options of CMake for a folder that is not configured yet.
"""

import base64
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from bundle import SEARCH_PATH, add_bundle, tag

try:
    import tomllib
except ImportError:  # Python before 3.11
    import tomli as tomllib

TOP = Path(__file__).resolve().parents[2]
PROGRAMS = ["graincrack-mesh", "graincrack-solve", "graincrack-post"]


def configure(folder, bundle):
    """Configures a build folder; if that fails for want of packages, one line names them."""
    command = ["cmake", "-S", TOP, "-B", folder]
    if (folder / "CMakeCache.txt").exists():
        sources = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)", (folder / "CMakeCache.txt").read_text(), re.M)[1]
        if Path(sources).resolve() != TOP:
            sys.exit(f"graincrack: --config-settings build-dir={folder}: is configured for the sources in {sources}, not {TOP}; name another")
    else:
        command = ["cmake", "--preset", "release", "-B", folder, "-DGRAINCRACK_TESTS=OFF", "-DGRAINCRACK_MPI=OFF"]
        command += shlex.split(os.environ.get("CMAKE_ARGS", "")) + (SEARCH_PATH if bundle else [])
    result = shutil.which("cmake") and subprocess.run(command, cwd=TOP, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if result and result.returncode == 0:
        return
    listing = ["bash", "-c", 'source share/setup.sh; missing_packages "${build_packages[@]/libopenmpi-dev/cmake}"']
    missing = " ".join(sorted(set(subprocess.run(listing, cwd=TOP, capture_output=True, text=True).stdout.split())))
    if missing and shutil.which("apt-get"):
        sys.exit(f"graincrack: packages are missing; with root rights: apt-get install --no-install-recommends {missing}")
    printed = result.stdout if result else "cmake: not found"
    sys.exit(f"{printed}\ngraincrack: not configured{missing and f'; needed are, by their Debian 12 names: {missing}'}")


def run(*command):
    if subprocess.run(command, cwd=TOP).returncode != 0:
        sys.exit(f"graincrack: failed, and no wheel was made: {shlex.join(map(str, command))}")


def project():
    """[project] of pyproject.toml, with the version, which is CMake's."""
    table = tomllib.loads((TOP / "pyproject.toml").read_text())["project"]
    return table | {"version": re.search(r"^project\(graincrack VERSION (\S+)", (TOP / "CMakeLists.txt").read_text(), re.M)[1]}


def name_and_version():
    return f"{project()['name']}-{project()['version']}"


def metadata():
    """The file METADATA of a wheel, PKG-INFO of an archive of sources."""
    table = project()
    lines = ["Metadata-Version: 2.4", f"Name: {table['name']}", f"Version: {table['version']}", f"Summary: {table['description']}"]
    lines += [f"License-Expression: {table['license']}", *(f"License-File: {each}" for each in table["license-files"])]
    lines += [f"Keywords: {','.join(table['keywords'])}", *(f"Classifier: {each}" for each in table["classifiers"])]
    lines += [f"Requires-Python: {table['requires-python']}", *(f"Requires-Dist: {each}" for each in table["dependencies"])]
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", (TOP / table["readme"]).read_text()])


def description(bundle):
    """The files that describe a wheel: content by name."""
    wheel = f"Wheel-Version: 1.0\nGenerator: graincrack\nRoot-Is-Purelib: false\nTag: {tag(bundle)}\n"
    return {"METADATA": metadata().encode(), "WHEEL": wheel.encode(), "licenses/LICENSE": (TOP / "LICENSE").read_bytes()}


def files_of(installed):
    """What a wheel has of an installation: pairs of name in the wheel and file. An environment has no place for licence and README."""
    data = f"{name_and_version()}.data"
    folders = ("lib/graincrack", "share/graincrack", "share/man", "share/bash-completion", "share/zsh")
    places = [(f"{data}/scripts", "bin"), *((f"{data}/data/{folder}", folder) for folder in folders)]
    places += [("", path) for path in installed.glob("lib/python*/dist-packages")]
    for place, folder in places:
        for path in sorted((installed / folder).rglob("*")):
            if path.is_file() and path.suffix != ".pyc":
                yield str(Path(place, path.relative_to(installed / folder))), path


def write_wheel(path, installed, described):
    """Writes a wheel, whose bytes depend on its content alone."""
    info = f"{name_and_version()}.dist-info"
    entries = [(name, file.read_bytes(), 0o755 if os.access(file, os.X_OK) else 0o644) for name, file in files_of(installed)]
    entries += [(f"{info}/{name}", content, 0o644) for name, content in described.items()]
    digests = [base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=") for _, content, _ in entries]
    record = [f"{name},sha256={digest},{len(content)}\n" for (name, content, _), digest in zip(entries, digests)]
    entries.append((f"{info}/RECORD", f"{''.join(record)}{info}/RECORD,,\n".encode(), 0o644))
    with zipfile.ZipFile(path, "w") as wheel:
        for name, content, mode in entries:
            entry = zipfile.ZipInfo(name)
            entry.external_attr = (0o100000 | mode) << 16
            wheel.writestr(entry, content, zipfile.ZIP_DEFLATED, compresslevel=9)


def options(config_settings):
    """The build folder, and whether the wheel has its libraries."""
    settings = dict(config_settings or {})
    folder, bundle = TOP / settings.pop("build-dir", "build-wheel"), settings.pop("bundle", "no")
    if settings or bundle not in ("yes", "no"):
        sys.exit(f"graincrack: --config-settings {next(iter(settings), f'bundle={bundle}')}: unknown; build-dir=FOLDER or bundle=yes fits")
    return folder, bundle == "yes"


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = Path(metadata_directory, f"{name_and_version()}.dist-info")
    for name, content in description(options(config_settings)[1]).items():
        (info / name).parent.mkdir(parents=True, exist_ok=True)
        (info / name).write_bytes(content)
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    folder, bundle = options(config_settings)
    configure(folder, bundle)
    run("cmake", "--build", folder, "--parallel", str(os.cpu_count()), "--target", *PROGRAMS, "packaging")
    name = f"{name_and_version()}-{tag(bundle)}.whl"
    with tempfile.TemporaryDirectory() as installed:
        run("cmake", "--install", folder, "--prefix", installed, "--strip")
        inside = add_bundle(Path(installed)) if bundle else {}
        write_wheel(Path(wheel_directory, name), Path(installed), description(bundle) | {f"licenses/{each}": inside[each] for each in inside})
    return name


def build_sdist(sdist_directory, config_settings=None):
    """The files of the commit that is checked out."""
    name = f"{name_and_version()}.tar.gz"
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "PKG-INFO").write_text(metadata())
        run("git", "archive", f"--prefix={name_and_version()}/", f"--add-file={folder}/PKG-INFO", "-o", Path(sdist_directory, name), "HEAD")
    return name
