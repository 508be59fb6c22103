#!/usr/bin/env bash
# Checks and measures the solver on a CUDA device: tests, compute-sanitizer on a small scene, rates, one full case of the
# paper. Needs a driver, bash, awk, gzip and the programs of `make static`; neither packages nor a network.
# usage: bench/gpu.sh OUT [--build build/static] [--device 0] [--tests S] [--sanitizer S] [--rates S] [--case S] [--bond B]
# S: seconds that a part may take; 0 leaves it out. Everything lands in the folder OUT: gpu.json, logs, the case's states.
# Calling it again continues the case from its last checkpoint.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
out=${1:?usage: bench/gpu.sh OUT [--build DIR] [--device N] [--tests S] [--sanitizer S] [--rates S] [--case S] [--bond B]}
shift
build=$root/build/static device=0 tests=300 sanitizer=120 rates=300 case=600 bond=50
while [ $# -gt 0 ]; do
    case $1 in
    --build | --device | --tests | --sanitizer | --rates | --case | --bond) declare "${1#--}=${2:?$1 needs a value}" ;;
    *) echo "gpu.sh: $1 is no option; see the head of this file" >&2 && exit 2 ;;
    esac
    shift 2
done
solver=$build/solver/recoat-solve
[ -x "$solver" ] || { echo "gpu.sh: $solver is missing; make static builds it" >&2; exit 2; }
mkdir -p "$out"
parts=()

# part NAME JSON: one entry of the result.
part() { parts+=("\"$1\": $2"); }

# gtest_part NAME SECONDS PROGRAM: all its tests on the device.
gtest_part() {
    local log=$out/$1.log rc=0
    RECOAT_TEST_BACKEND=cuda RECOAT_REFERENCE=$root/tests/analytic/reference.json \
        timeout "$2" "$3" --gtest_brief=1 >"$log" 2>&1 || rc=$?
    part "$1" "$(awk -v rc=$rc '/PASSED.*tests?\./ { passed = $4 } /FAILED.*tests?, listed/ { failed = $4 }
        END { printf "{\"exit_code\": %d, \"passed\": %d, \"failed\": %d, \"timed_out\": %s}", rc, passed, failed,
              rc == 124 ? "true" : "false" }' "$log")"
    [ $rc -eq 0 ] || tail -n 20 "$log" >&2
}

sanitize() {
    local tool=${COMPUTE_SANITIZER:-$(command -v compute-sanitizer || true)} check rc results=()
    if [ -z "$tool" ]; then
        part sanitizer '"compute-sanitizer is not on this machine"'
        return
    fi
    for check in memcheck racecheck synccheck initcheck; do
        rc=0
        rm -rf "$out/sanitized"
        timeout $((sanitizer / 4 + 1)) "$tool" --tool $check --error-exitcode 99 "$solver" run \
            "$root/config/examples/small_spread.yaml" --backend cuda --device "$device" --out "$out/sanitized" --quiet \
            --until-step 400 >"$out/$check.log" 2>&1 || rc=$?
        results+=("\"$check\": {\"exit_code\": $rc, \"summary\": \"$(grep -h 'SUMMARY' "$out/$check.log" | tail -n 1 | tr -d '="\\')\"}")
    done
    part sanitizer "{$(printf '%s, ' "${results[@]}" | sed 's/, $//')}"
}

measure_rates() {
    local end=$((SECONDS + rates)) tiles bo line lines=()
    gunzip -c "$root/bench/data/settled-bed.csv.gz" >"$out/bed.csv"
    for tiles in 1 10 100 1000; do
        for bo in 0 50 400; do
            [ $SECONDS -lt $end ] || break 2
            line=$(timeout $((end - SECONDS)) "$build/bench/step-rate" "$out/bed.csv" --scene "$root/config/scene.yaml" --backend cuda --device "$device" \
                --tiles $tiles --bond $bo --steps $((tiles > 100 ? 500 : 5000)) 2>>"$out/rates.log") || continue
            echo "$line" | tee -a "$out/rates.log"
            lines+=("$line")
        done
    done
    part rates "[$(printf '%s, ' ${lines[@]+"${lines[@]}"} | sed 's/, $//')]"
}

run_case() {
    local rc=0 start=$SECONDS
    timeout --signal TERM "$case" "$solver" run "$root/config/scene.yaml" --backend cuda --device "$device" \
        --out "$out/case" --set "cohesion.bond_number=$bond" --set "output.checkpoint_interval=60 s" \
        --set "output.trajectory_interval=0 s" 2>"$out/case.log" || rc=$?
    tail -n 3 "$out/case.log"
    part case "{\"bond_number\": $bond, \"exit_code\": $rc, \"seconds\": $((SECONDS - start)), \"summary\": $(awk \
        '!/"config":/' "$out/case/summary.json" 2>/dev/null || echo null)}"
}

[ "$tests" -eq 0 ] || gtest_part engine_tests "$tests" "$build/tests/solver/engine/test_engine"
[ "$tests" -eq 0 ] || gtest_part analytic_tests "$tests" "$build/tests/analytic/test_analytic"
[ "$sanitizer" -eq 0 ] || sanitize
[ "$rates" -eq 0 ] || measure_rates
[ "$case" -eq 0 ] || run_case
name=$(nvidia-smi --query-gpu=name,driver_version --format=csv,noheader -i "$device" 2>/dev/null || echo "unknown device")
part device "\"$name\""
part date "\"$(date -u +%F)\""
part program "\"$("$solver" --version)\""
part command "\"bench/gpu.sh OUT --tests $tests --sanitizer $sanitizer --rates $rates --case $case --bond $bond\""
printf '{%s}\n' "$(printf '%s,\n ' "${parts[@]}" | sed '$ s/,$//' | sed '/^ *$/d' | sed '$ s/,$//')" >"$out/gpu.json"
echo "Result: $out/gpu.json"
