#!/usr/bin/env python3
"""What --max-error and --time-limit promise, held against what comes out.

    benches/promises.py errors [--scene NAME]    true error over estimate, twelve scenes
    benches/promises.py others [--scene NAME]    the same on scenes by which nothing was adjusted
    benches/promises.py times [--scene NAME]     wall time over what was allowed

The truth is no adaptive picture: every pixel gets the same number of stratified samples, with other random numbers.
Its own error comes from a second one of its kind. GLINT names another program. Truths are kept in target/promises.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "target" / "promises"
GLINT = os.environ.get("GLINT", str(ROOT / "target" / "release" / "glint"))
SIZE = (128, 96)
TRUTH_SAMPLES = 512
ERRORS = ["0.01", "0.005"]
# Name, scene, words.
SCENES = [
    ("wires", "benches/scenes/trade/wires.pov", []),
    ("checkered horizon", "benches/scenes/trade/horizon.pov", []),
    ("area-lit room", "benches/scenes/trade/room.pov", []),
    ("glass bubbles", "scenes/bubbles.pov", []),
    ("sphereflake", "benches/scenes/sphereflake.pov", ["-D", "Depth=4"]),
    ("still life", "benches/scenes/trade/still_life.pov", []),
    ("machine part", "benches/scenes/trade/machine.pov", []),
    ("landscape", "benches/scenes/trade/landscape.pov", []),
    ("menger sponge", "scenes/menger.pov", []),
    ("stained glass", "scenes/stained_glass.pov", []),
    ("tiles", "scenes/tiles.pov", []),
    ("ripples", "scenes/ripples.pov", []),
]
# All scenes of the collection that are not among the twelve and whose truth takes less than ten minutes.
OTHERS = [
    (name.replace("_", " "), f"scenes/{name}.pov", [])
    for name in (
        "coaster", "colonnade", "finishes", "island", "isometric", "knot", "lanterns", "mirrors", "misty_wood",
        "patterns", "planet", "shapes", "sombrero", "spotlights", "sundial", "terrain", "tree",
    )
]
# The first factor is the one that at least ten scenes keep, the second the one that all keep.
FACTORS = (1.5, 2.0)


def render(scene, output, words, size=SIZE):
    command = [GLINT, "render", scene, "-o", str(output), "-W", str(size[0]), "-H", str(size[1]),
               "--json", "-q", "--bits", "16", *words]
    begun = time.monotonic()
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    wall = time.monotonic() - begun
    if done.returncode:
        sys.exit(f"Glint failed: {' '.join(command)}\n{done.stderr}")
    return json.loads(done.stdout), wall


def distance(a, b):
    done = subprocess.run([GLINT, "compare", str(a), str(b), "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["light"]["rmse"]


def truth(name, scene, words):
    """A picture and its own error."""
    both = [WORK / f"{name.replace(' ', '_')}_{TRUTH_SAMPLES}_{seed}.png" for seed in (1001, 1002)]
    for path in both:
        if not path.exists():
            seed = path.stem.rsplit("_", 1)[1]
            render(scene, path, [*words, "--min-samples", str(TRUTH_SAMPLES), "--seed", seed])
    return both[0], distance(*both) / math.sqrt(2)


def errors(chosen):
    print(f"{SIZE[0]}x{SIZE[1]} pixels; truth: {TRUTH_SAMPLES} stratified samples in every pixel.\n")
    print("| scene | truth's own error | " + " | ".join(f"X = {x}: estimate, true error, ratio" for x in ERRORS) + " |")
    print("|---|---|" + "---|" * len(ERRORS))
    ratios = {x: [] for x in ERRORS}
    for name, scene, words in chosen:
        exact, own = truth(name, scene, words)
        cells = []
        for x in ERRORS:
            output = WORK / "now.png"
            report, _ = render(scene, output, [*words, f"--max-error={x}"])
            estimate, error = report["adaptive"]["rmse_estimate"], distance(output, exact)
            ratio = error / estimate
            ratios[x].append(ratio)
            mark = "" if own <= float(x) / 4 else " (truth too coarse)"
            spp = report["adaptive"]["samples_per_pixel"]
            cells.append(f"{estimate:.5f}, {error:.5f}, **{ratio:.2f}** ({spp:.1f} spp){mark}")
        print(f"| {name} | {own:.5f} | " + " | ".join(cells) + " |", flush=True)
    print()
    for x, all_of_x in ratios.items():
        near = sum(1 / FACTORS[0] <= r <= FACTORS[0] for r in all_of_x)
        print(f"X = {x}: {near} of {len(all_of_x)} between 1/1.5 and 1.5; largest {max(all_of_x):.2f}, "
              f"smallest {min(all_of_x):.2f}")


def times(chosen):
    limits = [0.3, 1, 3]
    print("| scene | " + " | ".join(f"T = {t} s: wall, over" for t in limits) + " |")
    print("|---|" + "---|" * len(limits))
    late = 0
    for name, scene, words in chosen:
        cells = []
        for t in limits:
            report, wall = render(scene, WORK / "now.png", [*words, f"--time-limit={t}"], (1024, 768))
            over = wall - t
            broken = over > max(0.05 * t, 0.3)
            late += broken
            error = report["adaptive"]["rmse_estimate"]
            reached = "coarse" if error is None else f"{error:.4f}"
            cells.append(f"{wall:.2f}, {over:+.2f}{' LATE' if broken else ''} (error {reached})")
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)
    print(f"\n{late} of {len(chosen) * len(limits)} later than T + max(5 %, 0.3 s).")


def main():
    parser = argparse.ArgumentParser(description="What --max-error and --time-limit promise.")
    parser.add_argument("what", choices=["errors", "others", "times"])
    parser.add_argument("--scene", action="append", help="only this one")
    args = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    scenes = OTHERS if args.what == "others" else SCENES
    chosen = [s for s in scenes if not args.scene or s[0] in args.scene]
    (times if args.what == "times" else errors)(chosen)


if __name__ == "__main__":
    main()
