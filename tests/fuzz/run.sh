#!/usr/bin/env bash
# Fuzzes every reader: run.sh BUILD SECONDS [TARGET...]. Inputs grow in BUILD/corpus; what is found lies in BUILD/findings.
# Ends with a table of inputs tried and findings, and with 1 where there is one.
set -euo pipefail
build=$1 seconds=$2
shift 2
here=$(cd "$(dirname "$0")" && pwd)
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
    targets=(csv extended-xyz lammps-dump lammps-data yade-text mercury-data legacy-vtk vtk-xml series gzip packed sniffing hdf5-arrays hdf5-bytes)
fi
"$here/../../.venv/bin/python" "$here/seeds.py" "$build/seeds"
"$build/tests/fuzz/state_seed" "$build/seeds/hdf5-bytes/seed-state"
mkdir -p "$build/findings" "$build/logs"
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1
status=0
for target in "${targets[@]}"; do
    mkdir -p "$build/corpus/$target"
    dictionary=()
    [ -f "$here/dictionaries/$target.dict" ] && dictionary=("-dict=$here/dictionaries/$target.dict")
    longest=16384
    [ "$target" = hdf5-bytes ] && longest=131072
    log="$build/logs/$target.log" start=$SECONDS
    # Five seconds are a hang, 1 GiB in all or 256 MiB at once too much for inputs of some kilobytes.
    if ! nice -n 19 "$build/tests/fuzz/fuzz_$target" "${dictionary[@]}" -max_total_time="$seconds" -timeout=5 \
        -rss_limit_mb=1024 -malloc_limit_mb=256 -max_len="$longest" -print_final_stats=1 \
        -artifact_prefix="$build/findings/$target-" "$build/corpus/$target" "$build/seeds/$target" >"$log" 2>&1; then
        status=1
        echo "$target: see $log"
    fi
    echo "$target: $(sed -n 's/^stat::number_of_executed_units: //p' "$log" | tail -1) inputs in $((SECONDS - start)) s"
done
exit $status
