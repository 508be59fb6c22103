#!/usr/bin/env bash
# Builds the distribution's oneTBB with clang's thread sanitizer: build_tbb.sh FOLDER. The library hands work from thread
# to thread; compiled without the sanitizer, every handover looks like a race. Done once per version.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)
version=$(dpkg-query -W -f '${source:Version}' libtbb-dev)
if [ "$(cat "$folder/version" 2>/dev/null)" = "$version" ]; then
    echo "oneTBB $version with the thread sanitizer is there"
    exit
fi

# Package lists of sources in the folder: the system's own are left as they are.
fetch_source() {
    mkdir -p "$folder/lists/partial"
    local list
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/{debian,ubuntu}.sources; do
        [ -f "$list" ] && sed 's/^Types: *deb$/Types: deb-src/; s/^deb /deb-src /' "$list" >"$folder/${list##*/}"
    done
    local apt=(-q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$folder" -o Dir::State::lists="$folder/lists")
    apt-get update "${apt[@]}"
    apt-get source "${apt[@]}" "onetbb=$version"
}

rm -rf "$folder"/onetbb* "$folder/lib"
cd "$folder"
fetch_source >fetch.log 2>&1 || { cat fetch.log >&2; exit 1; }
cmake -G Ninja -S onetbb-*/ -B objects --log-level=WARNING --install-prefix "$folder" -D TBB_SANITIZE=thread \
    -D CMAKE_BUILD_TYPE=RelWithDebInfo -D CMAKE_CXX_FLAGS_RELWITHDEBINFO="-O2 -gline-tables-only" \
    -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ \
    -D TBB_TEST=OFF -D TBB_STRICT=OFF -D TBBMALLOC_BUILD=OFF -D CMAKE_INSTALL_LIBDIR=lib >configure.log
cmake --build objects --target install >build.log || { tail -30 build.log >&2; exit 1; }
rm -rf onetbb* objects lists
echo "$version" >version
echo "oneTBB $version is built with the thread sanitizer"
