"""What a wheel has inside so that its programs need nothing of a machine but glibc: shared libraries, a font, licences; from a Debian."""

import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
# Options of CMake: where the programs look for libraries. Of its two kinds in a program the older one holds for libraries of libraries too.
SEARCH_PATH = ["-DCMAKE_INSTALL_RPATH=$ORIGIN/../lib/graincrack", "-DCMAKE_EXE_LINKER_FLAGS=-Wl,--disable-new-dtags"]
GLIBC = re.compile(r"lib(c|m|mvec|dl|rt|pthread|resolv|util|anl)\.so")
FONTS = Path("/usr/share/fonts/truetype/liberation")
# Packages of which the programs have nothing but headers, and that of the font.
COMPILED_IN = ["libboost-dev", "libcgal-dev", "libcli11-dev", "libeigen3-dev", "nlohmann-json3-dev", "fonts-liberation"]


def tag(bundle):
    """What a wheel fits: this machine with its libraries, or every one with a glibc as new as this one."""
    glibc = "many" + os.confstr("CS_GNU_LIBC_VERSION").replace("glibc ", "linux_").replace(".", "_")
    return f"py3-none-{glibc if bundle else 'linux'}_{platform.machine()}"


def libraries(programs):
    """The shared libraries that programs load, but those of glibc: file by name."""
    printed = subprocess.run(["ldd", *programs], capture_output=True, text=True).stdout
    return {name: Path(file) for name, file in re.findall(r"^\s*(\S+) => (\S+)", printed, re.M) if not GLIBC.match(name)}


def licences(files):
    """The licences of libraries and of COMPILED_IN, as the Debian packages have them that they are of: content by name."""
    names = {name for file in files for name in (str(file.resolve()), str(file.resolve()).removeprefix("/usr"))}
    printed = subprocess.run(["dpkg-query", "--search", *sorted(names)], capture_output=True, text=True).stdout
    owned = [line.rpartition(": ") for line in printed.splitlines()]
    strangers = {file.resolve().name for file in files} - {Path(name).name for _, _, name in owned}
    if strangers:
        sys.exit(f"graincrack: bundle: {', '.join(sorted(strangers))}: of no Debian package, which would tell the licence")
    packages = sorted({package.split(":")[0] for package, _, _ in owned} | set(COMPILED_IN))
    texts = {f"{package}/copyright": Path("/usr/share/doc", package, "copyright").read_bytes() for package in packages}
    common = {name.decode() for text in texts.values() for name in re.findall(rb"/usr/share/common-licenses/([\w.-]*\w)", text)}
    common = [Path("/usr/share/common-licenses", name) for name in sorted(common)]
    return texts | {f"common-licenses/{file.name}": file.read_bytes() for file in common if file.exists()}


def add_bundle(installed):
    """Puts shared libraries and the font of pictures beside installed programs; returns the licences of what is inside: content by name."""
    programs = sorted((installed / "bin").iterdir())
    beside, fonts = installed / "lib/graincrack", installed / "share/graincrack/fonts"
    beside.mkdir(parents=True)
    files = libraries(programs)
    for name, file in files.items():
        shutil.copy(file, beside / name)
    outside = sorted(name for name, file in libraries(programs).items() if file.resolve().parent != beside.resolve())
    outside += sorted(name for name in files if name.startswith("libmpi"))
    if outside:
        sys.exit(f"graincrack: bundle: {', '.join(outside)}: not for a wheel; a build-dir that is not configured yet fits")
    fonts.mkdir()
    for file in [HERE / "fonts.conf", FONTS / "LiberationSans-Regular.ttf", FONTS / "LiberationSans-Bold.ttf"]:
        shutil.copy(file, fonts)
    return licences(files.values())
