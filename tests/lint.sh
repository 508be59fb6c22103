#!/usr/bin/env bash
# Style of all sources; clang-tidy for the C++ files that changed since the branch point (or the commit before).
# Needs the build folder RECOAT_BUILD (its compile commands) and .venv.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${RECOAT_BUILD:-build/release}

sources() { git ls-files --cached --others --exclude-standard -- "$@" | while read -r file; do [ -f "$file" ] && echo "$file"; done; }

changed_since() {
    local base
    base=$(git merge-base HEAD origin/main 2>/dev/null || true)
    if [ -z "$base" ] || [ "$base" = "$(git rev-parse HEAD)" ]; then
        base=$(git rev-parse --quiet --verify HEAD~1 || git hash-object -t tree /dev/null)
    fi
    git diff --name-only --diff-filter=d "$base" -- "$@"
}

echo "lint: clang-format"
sources '*.hpp' '*.cpp' | xargs -r clang-format --dry-run -Werror

echo "lint: clang-tidy"
# g++ keeps omp.h in a folder that clang does not search.
omp=$(dirname "$(g++ -print-file-name=include/omp.h)")
changed_since 'common/*.cpp' 'solver/*.cpp' 'analyzer/*.cpp' 'bench/*.cpp' |
    xargs -r -n 1 -P "$(nproc)" clang-tidy --quiet -p "$build" --extra-arg="-idirafter$omp" 2>&1 |
    { grep -vE '^[0-9]+ warnings (generated|treated)|^Suppressed|^Use -header-filter' || true; }

echo "lint: Python"
sources '*.py' | xargs -r .venv/bin/python -m py_compile

echo "lint: Snakemake"
.venv/bin/snakemake --lint --configfile config/reduced.yaml >/dev/null
echo "lint: good"
