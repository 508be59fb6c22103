#!/usr/bin/env bash
# Installs what Recoat needs on Debian 12 and Ubuntu 24.04: system packages (apt) and Python packages (.venv).
# Can be called again at any time; it only adds what is missing.
set -euo pipefail
cd "$(dirname "$0")"

packages=(
    build-essential cmake ninja-build ccache git clang-format clang-tidy
    libeigen3-dev libhdf5-dev libyaml-cpp-dev nlohmann-json3-dev libcli11-dev libfmt-dev libgtest-dev libgmock-dev libxsimd-dev
    libcgal-dev libgmp-dev libmpfr-dev
    libopenvdb-dev libtbb-dev libboost-iostreams-dev libblosc-dev libimath-dev zlib1g-dev libbz2-dev liblzma-dev libzstd-dev libexpat1-dev
    python3 python3-venv
    libegl1 libegl-mesa0 libgl1 libgl1-mesa-dri libxrender1 # off-screen rendering of the layer
)

# Only for `make fuzz` and `make sanitize`.
if [ -n "${RECOAT_FUZZ:-}${RECOAT_SANITIZE:-}" ]; then
    packages+=(clang libclang-rt-dev)
fi
# Only for `make sanitize`: OpenMP of clang, and what unpacks a source package.
if [ -n "${RECOAT_SANITIZE:-}" ]; then
    packages+=(libomp-dev dpkg-dev)
fi
# Only for `make bench`: a program to compare with, and what counts instructions.
if [ -n "${RECOAT_PEERS:-}" ]; then
    packages+=(liggghts valgrind)
fi
# Only for `make test-slurm`.
if [ -n "${RECOAT_SLURM:-}" ]; then
    packages+=(slurm-wlm munge)
fi

installed() { dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p'; }

install_system_packages() {
    if ! command -v apt-get >/dev/null; then
        echo "setup.sh: there is no apt-get here; install the counterparts of these packages: ${packages[*]}" >&2
        exit 1
    fi
    local missing
    mapfile -t missing < <(comm -23 <(printf '%s\n' "${packages[@]}" | sort -u) <(installed "${packages[@]}" | sort -u))
    if [ ${#missing[@]} -eq 0 ]; then
        echo "setup: system packages are there"
        return
    fi
    echo "setup: installing ${missing[*]}"
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "setup.sh: system packages are missing (${missing[*]}); call it as root, or install sudo" >&2
            exit 1
        fi
        as_root=(sudo)
    fi
    "${as_root[@]}" apt-get update -qq
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

install_python_packages() {
    local python=${PYTHON:-/usr/bin/python3}
    local version wanted there
    version=$("$python" --version)
    wanted="$version $(sha256sum requirements.txt | cut -d ' ' -f 1)"
    there=$(cat .venv/requirements.installed 2>/dev/null || true)
    if [ "$there" = "$wanted" ]; then
        echo "setup: Python packages are there"
        return
    fi
    echo "setup: installing Python packages into .venv"
    # Another Python needs another environment; otherwise what is there already stays.
    [ "${there% *}" = "$version" ] || "$python" -m venv --clear .venv
    .venv/bin/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
    echo "$wanted" >.venv/requirements.installed
}

install_system_packages
install_python_packages
