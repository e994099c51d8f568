#!/usr/bin/env python3
"""Tree, grid and plain list beside each other: where each of --accel's structures wins.

    benches/accel.py [--runs N] [--scene NAME]

Building: CPU seconds of preparing the scene beyond those that the plain list takes. Tracing: CPU microseconds a
ray (camera, shadow and reflected rays) on one thread, 320x240 pixels; lists of many objects 32x24 or 16x12. Memory: what
the structure keeps. The least of the runs, taken in turns. Pictures of all three are compared, byte by byte.
GLINT names another program; pictures go to target/accel.
"""

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "target" / "accel"
GLINT = os.environ.get("GLINT", str(ROOT / "target" / "release" / "glint"))
KINDS = ["bvh", "grid", "none"]
# Name, scene, declared numbers, objects.
SCENES = [
    ("one sphere", "accel.pov", ["Kind=1", "N=1"], 1),
    ("2 spheres", "accel.pov", ["Kind=1", "N=2"], 2),
    ("3 spheres", "accel.pov", ["Kind=1", "N=3"], 3),
    ("4 spheres", "accel.pov", ["Kind=1", "N=4"], 4),
    ("6 spheres", "accel.pov", ["Kind=1", "N=6"], 6),
    ("12 spheres", "accel.pov", ["Kind=1", "N=12"], 12),
    ("sphereflake, 7 381", "sphereflake.pov", ["Depth=4"], 7381),
    ("sphereflake, 66 430", "sphereflake.pov", ["Depth=5"], 66430),
    ("hills, 248 512 triangles", "accel.pov", ["Kind=3", "N=249000"], 248512),
    ("even cloud, 1 000 spheres", "accel.pov", ["Kind=2", "N=1000"], 1000),
    ("even cloud, 100 000 spheres", "accel.pov", ["Kind=2", "N=100000"], 100000),
    ("extents of 1 : 10^8, 3 000 spheres", "accel.pov", ["Kind=4", "N=3000"], 3000),
    ("heap in a stadium, 20 000", "accel.pov", ["Kind=5", "N=20000"], 20000),
]
# Lists longer than this are traced in small, or in very small.
LONG, HUGE = 500, 50_000


def glint(command, scene, declared, words):
    words = [GLINT, command, str(ROOT / "benches" / "scenes" / scene), "--json",
             *(w for d in declared for w in ("-D", d)), *words]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"Glint failed: {' '.join(words)}\n{done.stderr}")
    return json.loads(done.stdout)


def render(scene, declared, kind, size):
    output = WORK / f"{kind}.png"
    report = glint("render", scene, declared, ["-o", str(output), "-W", str(size[0]), "-H", str(size[1]), "-q",
                                               "--threads", "1", "--accel", kind])
    rays = sum(report[f"{name}_rays"] for name in ("camera", "shadow", "reflected", "refracted"))
    return report["prepare_cpu_s"], 1e6 * report["trace_cpu_s"] / rays, output.read_bytes()


def measure(name, scene, declared, objects, runs):
    small, full = (16, 12) if objects > HUGE else (32, 24), (320, 240)
    if len({render(scene, declared, kind, small)[2] for kind in KINDS}) != 1:
        sys.exit(f"{name}: pictures differ")
    best = {kind: (float("inf"), float("inf")) for kind in KINDS}
    for _ in range(runs):
        for kind in KINDS:
            size = small if kind == "none" and objects > LONG else full
            prepare, ray, _ = render(scene, declared, kind, size)
            best[kind] = (min(best[kind][0], prepare), min(best[kind][1], ray))
    kept = {kind: glint("explain", scene, declared, ["--accel", kind])["built"]["tree_bytes"] for kind in KINDS}
    cells = [f"{max(best[kind][0] - best['none'][0], 0) * 1e3:.1f}" for kind in KINDS[:2]]
    cells += [f"{best[kind][1]:.3g}" for kind in KINDS]
    cells += [f"{kept[kind] / 1e6:.2f}" for kind in KINDS[:2]]
    quickest = min(KINDS, key=lambda kind: best[kind][1])
    print(f"| {name} | " + " | ".join(cells) + f" | {quickest} | {best['grid'][1] / best['bvh'][1]:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description="Tree, grid and list beside each other.")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--scene", action="append", help="only this one")
    args = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    print("| scene | building, ms: bvh | grid | tracing, µs a ray: bvh | grid | none | MB: bvh | grid | quickest | "
          "grid / bvh |\n|---|" + "---|" * 9)
    for name, scene, declared, objects in SCENES:
        if not args.scene or name in args.scene:
            measure(name, scene, declared, objects, args.runs)


if __name__ == "__main__":
    main()
