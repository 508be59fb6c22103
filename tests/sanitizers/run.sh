#!/usr/bin/env bash
# Builds with each of the sanitizers and runs what they must find clean: run.sh CORES.
set -euo pipefail
cd "$(dirname "$0")/../.."
cores=$1 status=0
for preset in asan tsan; do
    cmake --preset "$preset" --log-level=WARNING >/dev/null
    cmake --build --preset "$preset" --parallel "$cores"
    ctest --preset "$preset" --label-regex '^(sanitizer|unit|analytic)$' --parallel "$cores" || status=1
done
exit $status
