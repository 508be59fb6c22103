#!/usr/bin/env bash
# Steps the same settled bed of 10,000 particles with recoat and with LIGGGHTS (package liggghts), on one core each, in
# turn, and writes the rates and their ratio as JSON.
# usage: bench/side_by_side.sh OUT.json [repeats=5] [steps=2000] [skin of LIGGGHTS in m=2.5e-6]
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
out=${1:?name the file for the result} repeats=${2:-5} steps=${3:-2000} skin=${4:-2.5e-6} warm=500
program=${RECOAT_BUILD:-$root/build/release}/bench/step-rate
[ -x "$program" ] || { echo "$program is missing: make build first" >&2; exit 2; }
command -v liggghts >/dev/null || { echo "liggghts is not installed: apt install liggghts" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
gunzip -c "$root/bench/data/settled-bed.csv.gz" >"$work/bed.csv"
awk -F, 'NR > 1 { rows[++n] = n " 1 " 2 * $4 " 4430 " $1 " " $2 " " $3 }
    END { print "bed\n\n" n " atoms\n1 atom types\n\n0 0.001 xlo xhi\n0 0.001 ylo yhi\n0 0.0015 zlo zhi\n\nAtoms\n"
          for (i = 1; i <= n; ++i) print rows[i] }' OFMT='%.10g' CONVFMT='%.10g' "$work/bed.csv" >"$work/bed.data"

export OMP_NUM_THREADS=1
for ((k = 0; k < repeats; ++k)); do
    "$program" "$work/bed.csv" --scene "$root/config/scene.yaml" --warm $warm --steps "$steps" >>"$work/recoat"
    (cd "$work" && liggghts -in "$root/bench/peers/liggghts.in" -log none -var data bed.data -var warm $warm \
        -var steps "$steps" -var skin "$skin" >log 2>&1)
    awk -v s="$steps" '/^Loop time of/ { t = $4; for (i = 5; i < NF; ++i) if ($i == "with") n = $(i + 1) }
        END { printf "%.6g\n", n * s / t }' "$work/log" >>"$work/liggghts"
done
python3 - "$work" "$out" "$steps" "$skin" <<'END'
import datetime, json, pathlib, platform, statistics, subprocess, sys

work, out, steps, skin = pathlib.Path(sys.argv[1]), *sys.argv[2:]
recoat = [json.loads(line)["particle_steps_per_second"] for line in open(work / "recoat")]
peer = [float(line) for line in open(work / "liggghts")]
cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "unknown")
commit = subprocess.run(["git", "describe", "--always", "--dirty"], capture_output=True, text=True).stdout.strip()
result = {
    "what": "particle-steps per second on one core, settled bed of 10,000 equal spheres, Bond number 0, step 2e-8 s",
    "command": f"bench/side_by_side.sh OUT {len(recoat)} {steps} {skin}",
    "date": datetime.date.today().isoformat(),
    "machine": f"{cpu}, {platform.machine()}",
    "commit": commit,
    "recoat": {"median": statistics.median(recoat), "all": recoat},
    "liggghts_3.8": {"median": statistics.median(peer), "all": peer, "skin_m": float(skin)},
    "ratio_of_medians": statistics.median(recoat) / statistics.median(peer),
    "ratio_pair_by_pair": [a / b for a, b in zip(recoat, peer)],
}
pathlib.Path(out).write_text(json.dumps(result, indent=2) + "\n")
print(f"recoat {result['recoat']['median']:.3g}/s, LIGGGHTS {result['liggghts_3.8']['median']:.3g}/s,"
      f" ratio {result['ratio_of_medians']:.2f}")
END
