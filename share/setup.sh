# Sourced by share/quickstart, tests/run and .ci/run: the Debian 12 packages of the project and its build folders.
# shellcheck shell=bash disable=SC2034

# What the three tools are built from, with the font of pictures.
build_packages=(
    cmake g++ ninja-build
    libcairo2-dev libcgal-dev libcli11-dev libeigen3-dev libfmt-dev libgsl-dev libhdf5-dev libmd4c-dev libmd4c-html0-dev
    libpango1.0-dev libpng-dev libsqlite3-dev libssl-dev libtomlplusplus-dev libvtk9-dev nlohmann-json3-dev pkg-config
    fonts-liberation
)
# What the tests add: their framework, and what share/python and its examples need.
test_packages=(libgtest-dev python3-h5py python3-matplotlib)
# What the benchmarks add.
benchmark_packages=(libbenchmark-dev)
# What counts instructions.
counting_packages=(valgrind)
# What checks the form of the sources.
rule_packages=(clang-format clang-tidy git perl-base python3 shellcheck)
# What the builds with the other compiler add, with its sanitizers and the names in their reports.
clang_packages=(clang libclang-rt-dev llvm)

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

# have_packages PACKAGE…: installs what is missing if it may; ends the script with exit code 3 if it may not.
have_packages() {
    local package status missing=()
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "this is no Debian; going on with what is here. Needed are, by their Debian 12 names: $*"
        return 0
    fi
    for package in "$@"; do
        status=$(dpkg-query --show --showformat='${db:Status-Status} ' "$package" 2>/dev/null) || status=
        # "not-installed" is the status of what another package only mentions.
        [[ " $status" == *" installed "* ]] || missing+=("$package")
    done
    if ((${#missing[@]} == 0)); then
        say "packages: all there"
        return 0
    fi
    if ((EUID != 0)); then
        say "packages are missing: ${missing[*]}"
        say "with root rights: apt-get update && apt-get install --no-install-recommends ${missing[*]}"
        exit 3
    fi
    say "packages: installing ${missing[*]} and what they need; this takes some minutes"
    export DEBIAN_FRONTEND=noninteractive
    if ! { apt-get update -qq && apt-get install -qq -y --no-install-recommends "${missing[@]}"; } </dev/null >/dev/null; then
        say "packages could not be installed: ${missing[*]}"
        exit 3
    fi
}

# configure_build FOLDER PRESET [CMAKE OPTION…]: the build that is there, or a new one by its preset. From the top folder.
configure_build() {
    local folder=$1 preset=$2 launcher=()
    shift 2
    if [[ -f $folder/CMakeCache.txt ]]; then
        cmake -S . -B "$folder" "$@"
    else
        if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
        cmake --preset "$preset" "${launcher[@]}" "$@"
    fi
}
