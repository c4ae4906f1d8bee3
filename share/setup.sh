# Sourced by share/quickstart, tests/run and .ci/run: the Debian 12 packages of the project and its build folders.
# shellcheck shell=bash disable=SC2034

# What the three tools are built from, with the font of pictures.
build_packages=(
    cmake g++ ninja-build
    libcairo2-dev libcgal-dev libcli11-dev libeigen3-dev libfmt-dev libgsl-dev libhdf5-dev libopenmpi-dev
    libpango1.0-dev libpng-dev libsqlite3-dev libssl-dev libtomlplusplus-dev libvtk9-dev nlohmann-json3-dev pkg-config zlib1g-dev
    fonts-liberation
)
# What the tests add: their framework, and what share/python and its examples need.
test_packages=(libgtest-dev openmpi-bin python3-h5py python3-matplotlib)
# What opens reports as a person does; without it that test of tests/run --all is skipped.
browser_packages=(chromium poppler-utils)
# What makes environments of Python; without it the test of `pip install .` and of wheels is skipped.
environment_packages=(make python3-venv)
# What the benchmarks add.
benchmark_packages=(libbenchmark-dev)
# What counts instructions.
counting_packages=(valgrind)
# What checks the form of the sources.
rule_packages=(clang-format clang-tidy git perl-base python3 shellcheck)
# What the builds with the other compiler add, with its sanitizers and the names in their reports.
clang_packages=(clang libclang-rt-dev llvm)

say() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

# stage NAME: begins a stage of the script. When the script ends, however it does, it prints what each stage took.
stage_names=()
stage_starts=()
stage() {
    ((${#stage_names[@]} > 0)) || trap 'print_stages $?' EXIT
    stage_names+=("$1")
    stage_starts+=("$SECONDS")
    say "$1"
}
print_stages() {
    local i end all=$((SECONDS - stage_starts[0]))
    stage_starts+=("$SECONDS")
    printf '\n%-40s  seconds  share\n' stage >&2
    for i in "${!stage_names[@]}"; do
        end=${stage_starts[i + 1]}
        printf '%-40s  %7d  %3d %%\n' "${stage_names[i]}" $((end - stage_starts[i])) $((100 * (end - stage_starts[i]) / (all > 0 ? all : 1))) >&2
    done
    say "ended with exit code $1, after $all s"
}

# What takes long, s, on the machine where the objects of the probe below take reference_probe CPU seconds, on two cores.
declare -A reference_seconds=([tools]=110 [build]=190 [tests]=260 ["sanitized build"]=300 ["sanitized tests"]=400 [verification]=600 [pictures]=60)
reference_probe=0.85

# estimate NAME…: says how long these take here, by the time in which one source compiles. From the top folder, with a compiler.
estimate() {
    local name probe cores text=
    probe=$({ TIMEFORMAT=%U && time c++ -std=c++20 -O2 -I. -c share/base/units.cpp -o /dev/null; } 2>&1)
    for name in "$@"; do
        cores=$(nproc)
        if [[ $name != tools && $name != *build && $cores -gt 2 ]]; then cores=2; fi
        text+=$(awk -v name="$name" -v s="${reference_seconds[$name]}" -v probe="$probe" -v usual="$reference_probe" -v cores="$cores" 'BEGIN {
            s *= probe / usual * 2 / cores
            if (s < 90) printf "%s about %.0f s, ", name, s; else printf "%s about %.0f min, ", name, s / 60 }')
    done
    say "${text%, } here, unless other work slows it down"
}

# missing_packages PACKAGE…: those that are not installed, one a line.
missing_packages() {
    local package status
    for package in "$@"; do
        status=$(dpkg-query --show --showformat='${db:Status-Status} ' "$package" 2>/dev/null) || status=
        # "not-installed" is the status of what another package only mentions.
        [[ " $status" == *" installed "* ]] || echo "$package"
    done
}

# have_packages PACKAGE…: installs what is missing if it may; ends the script with exit code 3 if it may not.
have_packages() {
    local missing
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        say "this is no Debian; going on with what is here. Needed are, by their Debian 12 names: $*"
        return 0
    fi
    mapfile -t missing < <(missing_packages "$@")
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

# configure_build FOLDER PRESET [CMAKE OPTION…]: the build that is there, or a new one by a preset and these options. From the top folder.
configure_build() {
    local folder=$1 preset=$2 launcher=()
    shift 2
    if [[ -f $folder/CMakeCache.txt ]]; then
        cmake -S . -B "$folder" "$@"
    else
        if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
        cmake --preset "$preset" -B "$folder" "${launcher[@]}" "$@"
    fi
}
