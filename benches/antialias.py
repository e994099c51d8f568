#!/usr/bin/env python3
"""What -A costs and brings: adaptive sampling beside methods 1 and 2 over the scene collection.

    benches/antialias.py [--runs N] [--size WxH] [--target ERROR]... [SCENE...]

For each scene: CPU seconds of tracing on one thread and decibels against a picture with 256 stratified samples in
every pixel, for no anti-aliasing, methods 1 and 2 with their defaults (-A=0.3, depth 3), plain -A, and --target's
errors. Below the table: medians, and times over method 1's. GLINT names another program; truths are kept in
target/antialias.
"""

import argparse
import json
import math
import os
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "target" / "antialias"
GLINT = os.environ.get("GLINT", str(ROOT / "target" / "release" / "glint"))
TRUTH_SAMPLES = 256


def render(scene, output, size, words):
    """CPU seconds of tracing, and samples a pixel where they are counted."""
    command = [GLINT, "render", str(scene), "-o", str(output), "-W", str(size[0]), "-H", str(size[1]),
               "--threads", "1", "--bits", "16", "--json", "-q", *words]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"Glint failed: {' '.join(command)}\n{done.stderr}")
    report = json.loads(done.stdout)
    return report["trace_cpu_s"], (report["adaptive"] or {}).get("samples_per_pixel")


def decibels(a, b):
    done = subprocess.run([GLINT, "compare", str(a), str(b), "--json"], capture_output=True, text=True, check=True)
    db = json.loads(done.stdout)["light"]["psnr_db"]
    return math.inf if db is None else db


def main():
    parser = argparse.ArgumentParser(description="Adaptive sampling beside methods 1 and 2.")
    parser.add_argument("--runs", type=int, default=2)
    parser.add_argument("--size", default="160x120")
    parser.add_argument("--target", action="append", default=[], help="also --max-error, with a sample in every pixel")
    parser.add_argument("scenes", nargs="*", type=Path)
    args = parser.parse_args()
    size = tuple(map(int, args.size.split("x")))
    WORK.mkdir(parents=True, exist_ok=True)
    ways = [("none", []), ("method 1", ["--aa-method", "1", "-A=0.3"]), ("method 2", ["--aa-method", "2", "-A=0.3"]),
            ("-A", ["-A"])]
    ways += [(f"error {t}", [f"--max-error={t}", "--min-samples=1"]) for t in args.target]
    print("| scene | " + " | ".join(f"{name}: s, dB" for name, _ in ways) + " |\n|---|" + "---|" * len(ways))
    results = {name: [] for name, _ in ways}
    for scene in args.scenes or sorted((ROOT / "scenes").glob("*.pov")):
        truth = WORK / f"{scene.stem}_{args.size}.png"
        if not truth.exists():
            render(scene, truth, size, ["--min-samples", str(TRUTH_SAMPLES), "--seed", "501"])
        cells = []
        for name, words in ways:
            output = WORK / "now.png"
            runs = [render(scene, output, size, words) for _ in range(args.runs)]
            seconds, db = min(r[0] for r in runs), decibels(output, truth)
            results[name].append((seconds, db))
            rate = f", {runs[0][1]:.1f} spp" if runs[0][1] else ""
            cells.append(f"{seconds:.3f}, {db:.1f}{rate}")
        print(f"| {scene.stem} | " + " | ".join(cells) + " |", flush=True)
    print("\n| | median dB | least dB | time over method 1's: median | geometric mean | largest |\n|---|---|---|---|---|---|")
    for name, found in results.items():
        ratios = [a[0] / b[0] for a, b in zip(found, results["method 1"])]
        db = [d for _, d in found]
        mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
        print(f"| {name} | {statistics.median(db):.1f} | {min(db):.1f} | {statistics.median(ratios):.2f} | {mean:.2f} | "
              f"{max(ratios):.2f} |")


if __name__ == "__main__":
    main()
