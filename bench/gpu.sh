#!/usr/bin/env bash
# Checks and measures the solver on a CUDA device, the most telling first, within one limit of time: what the device is,
# the engine's tests, the same bits twice for a million moving particles, rates at rest and moving, a sweep of four
# cases, compute-sanitizer on the tests of both backends, one case of the paper, the analytic tests.
# Needs a driver, bash, awk, gzip and the programs of `make static`; neither packages nor a network.
# usage: bench/gpu.sh OUT [--build build/static] [--device 0] [--limit 540] [--bond 50]
# Everything lands in the folder OUT: gpu.json, written anew after every part, also when the script is ended by a signal;
# logs; the states of the case. Calling it again continues the case from its last checkpoint.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
usage="usage: bench/gpu.sh OUT [--build DIR] [--device N] [--limit SECONDS] [--bond B]"
out=${1:?$usage}
shift
build=$root/build/static device=0 limit=540 bond=50
while [ $# -gt 0 ]; do
    case $1 in
    --build | --device | --limit | --bond) declare "${1#--}=${2:?$1 needs a value}" ;;
    *) echo "gpu.sh: $1 is no option; $usage" >&2 && exit 2 ;;
    esac
    shift 2
done
solver=$build/solver/recoat-solve rate=$build/bench/step-rate
engine_tests=$build/tests/solver/engine/test_engine analytic_tests=$build/tests/analytic/test_analytic
for program in "$solver" "$rate" "$engine_tests" "$analytic_tests"; do
    [ -x "$program" ] || { echo "gpu.sh: $program is missing; make static builds it" >&2; exit 2; }
done
mkdir -p "$out"
export RECOAT_TEST_BACKEND=cuda RECOAT_TEST_DEVICE=$device RECOAT_REFERENCE=$root/tests/analytic/reference.json
child='' running='' parts=()

text() { printf '"%s"' "$(tr -d '\000-\037\\"' <<<"$1")"; }
left() { echo $((limit - SECONDS)); }
least() { echo $(($1 < $2 ? $1 : $2)); }

# part NAME JSON: one entry of the result, which is written at once.
part() {
    parts+=("$(text "$1"): $2")
    local joined
    joined=$(printf '%s,\n ' "${parts[@]}")
    printf '{%s}\n' "${joined%,*}" >"$out/gpu.json.new"
    mv "$out/gpu.json.new" "$out/gpu.json"
}

# A signal ends what runs, is noted, and ends the script.
stop() {
    trap '' TERM INT HUP
    [ -z "$child" ] || kill -TERM "$child" 2>/dev/null || true
    [ -z "$running" ] || part "$running" "{\"interrupted\": true, \"seconds\": $SECONDS}"
    exit 143
}
trap stop TERM INT HUP

# within SECONDS COMMAND ...: its exit code lands in `rc` (124 where the time was up), its time in `took`.
rc=0 took=0
within() {
    local seconds=$1 start=$SECONDS
    shift
    timeout --kill-after 5 --signal TERM "$seconds" "$@" &
    child=$!
    rc=0
    wait "$child" || rc=$?
    child=''
    took=$((SECONDS - start))
}

# begin NAME SECONDS: whether there is time for it; `for_part` is what it may take.
for_part=0
begin() {
    for_part=$(least "$2" "$(left)")
    running=$1
    [ "$for_part" -gt 1 ] && return
    running=''
    part "$1" '"no time was left"'
    return 1
}
end_part() {
    part "$running" "$1"
    running=''
}

describe_device() {
    begin device 20 || return 0
    local fields=name,driver_version,memory.total,compute_cap,compute_mode,ecc.errors.uncorrected.volatile.total,clocks.max.sm,power.limit
    within "$for_part" nvidia-smi --query-gpu=$fields --format=csv,noheader -i "$device" >"$out/device.csv" 2>"$out/device.log"
    end_part "{\"exit_code\": $rc, \"fields\": $(text "$fields"), \"values\": $(text "$(head -n 1 "$out/device.csv")")}"
}

# gtest_part NAME SECONDS PROGRAM: all its tests on the device, counted as they end.
gtest_part() {
    begin "$1" "$2" || return 0
    within "$for_part" "$3" >"$out/$1.log" 2>&1
    end_part "$(awk -v rc=$rc -v took=$took '
        /^\[       OK \] / { ++passed }
        /^\[  FAILED  \] .*\([0-9]+ ms\)/ { name = $4; sub(/,$/, "", name); failed[++failures] = name }
        /^\[  SKIPPED \] .*\([0-9]+ ms\)/ { ++skipped }
        END {
            printf "{\"exit_code\": %d, \"seconds\": %d, \"passed\": %d, \"skipped\": %d, \"failed\": [", rc, took, passed, skipped
            for (k = 1; k <= failures; ++k) printf "%s\"%s\"", (k > 1 ? ", " : ""), failed[k]
            printf "], \"timed_out\": %s}", (rc == 124 ? "true" : "false")
        }' "$out/$1.log")"
    [ $rc -eq 0 ] || tail -n 20 "$out/$1.log" >&2
}

# rate_line SECONDS OPTION ...: what step-rate prints, in `line`; empty where it failed.
line=''
rate_line() {
    local seconds=$1
    shift
    within "$seconds" "$rate" "$out/bed.csv" --scene "$root/config/scene.yaml" --backend cuda --device "$device" \
        --threads "$(nproc)" "$@" >"$out/rate.json" 2>>"$out/rates.log"
    line=''
    [ $rc -ne 0 ] || line=$(cat "$out/rate.json")
    echo "$* -> exit code $rc, $took s: $line" | tee -a "$out/rates.log"
}

value_of() { sed -n "s/.*\"$1\": \"\{0,1\}\([^,\"}]*\).*/\1/p" <<<"$2"; }

compare_bits() {
    begin same_bits 90 || return 0
    local end=$((SECONDS + for_part)) hashes=()
    for _ in 1 2; do
        [ $((end - SECONDS)) -lt 1 ] || rate_line $((end - SECONDS)) --tiles 100 --bond 50 --moving 0.1 --warm 100 --steps 400
        hashes+=("$(value_of state_hash "$line")")
    done
    local equal=false
    if [ -z "${hashes[0]}" ] || [ -z "${hashes[1]}" ]; then equal=null; fi
    if [ -n "${hashes[0]}" ] && [ "${hashes[0]}" = "${hashes[1]}" ]; then equal=true; fi
    end_part "{\"exit_code\": $rc, \"particles\": $(value_of particles "$line" | grep . || echo null), \"hashes\": [$(text "${hashes[0]}"), $(text "${hashes[1]}")], \"equal\": $equal}"
}

measure_rates() {
    begin rates 130 || return 0
    local end=$((SECONDS + for_part)) lines=() planned=0 tiles bond moving
    while read -r tiles bond moving steps; do
        planned=$((planned + 1))
        [ $((end - SECONDS)) -gt 1 ] || continue
        rate_line $((end - SECONDS)) --tiles "$tiles" --bond "$bond" --moving "$moving" --steps "$steps" </dev/null
        [ -z "$line" ] || lines+=("$line")
    done <<<"10 0 0 4000
10 0 0.1 4000
10 50 0 4000
10 50 0.1 4000
100 0 0.1 1000
100 50 0.1 1000
100 0 0 1000
1 0 0 5000
1 0 0.1 5000
1 50 0.1 5000
10 400 0.1 2000
1000 0 0.1 200"
    local joined
    joined=$(printf '%s,\n  ' ${lines[@]+"${lines[@]}"})
    end_part "{\"planned\": $planned, \"measured\": [${joined%,*}]}"
}

# run_json FOLDER: steps and seconds of a run, from its summary.
run_json() {
    awk '/^  "(particles|bond_number|steps|time|wall_seconds)":/ { sub(/,$/, ""); sub(/^ */, ""); list = list (list ? ", " : "") $0 }
        /^  "status":/ { sub(/,$/, ""); sub(/^ */, ""); list = list (list ? ", " : "") $0 }
        END { printf "{%s}", list }' "$1/summary.json" 2>/dev/null || echo null
}

run_sweep() {
    begin sweep 60 || return 0
    local b joined runs=()
    rm -rf "$out/sweep"
    {
        echo "scene: $root/config/scene.yaml"
        echo "cases:"
        for b in 0 50 200 400; do echo "  - {out: sweep/bond-$b, set: [cohesion.bond_number=$b, output.trajectory_interval=0 s]}"; done
    } >"$out/sweep.yaml"
    # Told to stop, the cases write what they have done.
    within $((for_part - 8)) "$solver" sweep "$out/sweep.yaml" --backend cuda --device "$device" --quiet >"$out/sweep.log" 2>&1
    for b in 0 50 200 400; do runs+=("$(run_json "$out/sweep/bond-$b")"); done
    joined=$(printf '%s,\n  ' "${runs[@]}")
    end_part "{\"exit_code\": $rc, \"seconds\": $took, \"cases\": [${joined%,*}]}"
}

sanitize() {
    begin sanitizer 80 || return 0
    local tool=${COMPUTE_SANITIZER:-$(command -v compute-sanitizer || true)} check end=$((SECONDS + for_part)) results=()
    if [ -z "$tool" ]; then
        end_part '"compute-sanitizer is not on this machine"'
        return
    fi
    for check in memcheck racecheck initcheck synccheck; do
        [ $((end - SECONDS)) -gt 1 ] || continue
        within $((end - SECONDS)) "$tool" --tool $check --error-exitcode 99 "$engine_tests" \
            --gtest_filter='*Backends.TwoRuns*/1:*Backends.Agree*/4' >"$out/$check.log" 2>&1
        results+=("\"$check\": {\"exit_code\": $rc, \"seconds\": $took, \"summary\": $(text "$(grep -h 'SUMMARY' "$out/$check.log" | tail -n 1)")}")
    done
    end_part "{$(printf '%s, ' ${results[@]+"${results[@]}"} | sed 's/, $//')}"
}

run_case() {
    begin case $(($(left) - 60)) || return 0
    within $((for_part - 8)) "$solver" run "$root/config/scene.yaml" --backend cuda --device "$device" \
        --out "$out/case" --set "cohesion.bond_number=$bond" --set "output.checkpoint_interval=60 s" \
        --set "output.trajectory_interval=0 s" >"$out/case.log" 2>&1
    end_part "{\"exit_code\": $rc, \"seconds\": $took, \"run\": $(run_json "$out/case")}"
}

part date "\"$(date -u +%F)\""
part program "$(text "$("$solver" --version | head -n 1)")"
part command "$(text "bench/gpu.sh OUT --device $device --limit $limit --bond $bond")"
gunzip -c "$root/bench/data/settled-bed.csv.gz" >"$out/bed.csv"
describe_device
gtest_part engine_tests 120 "$engine_tests"
compare_bits
measure_rates
run_sweep
sanitize
run_case
gtest_part analytic_tests "$(left)" "$analytic_tests"
part seconds "$SECONDS"
echo "Result: $out/gpu.json"
