#!/usr/bin/env python3
"""Time against error over the scene collection: `glint trade` for every scene, as a table and as plots.

    benches/trade_collection.py [--budget T] [--size WxH] [--svg FILE] [SCENE...]

Printed: CPU milliseconds in which each method comes to 35 and 40 dB, on straight lines between its best settings. The plots
show every point that was measured, and each method's best. GLINT names another program.
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
GLINT = os.environ.get("GLINT", str(ROOT / "target" / "release" / "glint"))
METHODS = {"adaptive": "#1f5fa8", "1": "#c8501e", "2": "#2e8b57"}
WANTED = [35.0, 40.0]
CELL, ACROSS = (230, 170), 5


def measure(scene, size, budget):
    command = [GLINT, "trade", str(scene), "-W", str(size[0]), "-H", str(size[1]), "--budget", budget,
               "--settings", "aa", "--json", "-q"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"Glint failed: {' '.join(command)}\n{done.stderr}")
    points = {}
    for row in json.loads(done.stdout)["rows"]:
        points.setdefault(row["settings"]["aa_method"], []).append((row["cpu_s"], row["psnr_db"] or 99.0))
    return points


def time_to(points, wanted):
    """Between the points of a front, along decibels and the logarithm of time."""
    before = None
    for s, db in front(points):
        if db >= wanted:
            if before is None:
                return s
            share = (wanted - before[1]) / (db - before[1])
            return before[0] * (s / before[0]) ** share
        before = s, db
    return None


def front(points):
    """Points that no quicker one beats."""
    best, kept = -math.inf, []
    for s, db in sorted(points):
        if db > best:
            kept.append((s, db))
            best = db
    return kept


def plot(results):
    """One small plot a scene: logarithmic time, decibels from 20 to 60."""
    rows = math.ceil(len(results) / ACROSS)
    width, height = CELL[0] * ACROSS, CELL[1] * rows + 30
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
           f'font-size="10"><rect width="{width}" height="{height}" fill="white"/>']
    for k, (method, colour) in enumerate(METHODS.items()):
        name = "adaptive" if method == "adaptive" else f"method {method}"
        out.append(f'<circle cx="{20 + 110 * k}" cy="14" r="4" fill="{colour}"/>'
                   f'<text x="{28 + 110 * k}" y="18">{name}</text>')
    out.append(f'<text x="{width - 10}" y="18" text-anchor="end">down: decibels, 20 to 60; across: CPU seconds, '
               "a line for each power of two</text>")
    for i, (name, points) in enumerate(results.items()):
        left, top = i % ACROSS * CELL[0] + 30, i // ACROSS * CELL[1] + 50
        w, h = CELL[0] - 45, CELL[1] - 45
        times = [math.log2(s) for found in points.values() for s, _ in found]
        low, high = math.floor(min(times)), math.ceil(max(times))

        def at(s, db):
            x = left + (math.log2(s) - low) / max(high - low, 1) * w
            return x, top + h - (min(max(db, 20.0), 60.0) - 20.0) / 40.0 * h

        out.append(f'<text x="{left}" y="{top - 6}" font-weight="bold">{name}</text>')
        for db in (20, 30, 40, 50, 60):
            y = at(2.0 ** low, db)[1]
            out.append(f'<line x1="{left}" y1="{y:.1f}" x2="{left + w}" y2="{y:.1f}" stroke="#ddd"/>'
                       f'<text x="{left - 4}" y="{y + 3:.1f}" text-anchor="end" fill="#666">{db}</text>')
        for t in range(low, high + 1):
            x = at(2.0 ** t, 20)[0]
            out.append(f'<line x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{top + h}" stroke="#eee"/>')
        for t in (low, high):
            x = at(2.0 ** t, 20)[0]
            out.append(f'<text x="{x:.1f}" y="{top + h + 12}" text-anchor="middle" fill="#666">{2.0 ** t:.3g}</text>')
        for method, colour in METHODS.items():
            found = points.get(method, [])
            line = " ".join("{:.1f},{:.1f}".format(*at(*p)) for p in front(found))
            out.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
            out += ['<circle cx="{:.1f}" cy="{:.1f}" r="2.2" fill="{}"/>'.format(*at(*p), colour) for p in found]
    return "\n".join(out) + "\n</svg>\n"


def main():
    parser = argparse.ArgumentParser(description="Time against error over the scene collection.")
    parser.add_argument("--budget", default="6s", help="a scene")
    parser.add_argument("--size", default="240x180")
    parser.add_argument("--svg", type=Path)
    parser.add_argument("scenes", nargs="*", type=Path)
    args = parser.parse_args()
    size = tuple(map(int, args.size.split("x")))
    heads = [f"{db:.0f} dB: {name}" for db in WANTED for name in ("adaptive", "method 1", "method 2")]
    print("| scene | " + " | ".join(heads) + " |\n|---|" + "---|" * len(heads))
    results, ratios = {}, {db: [] for db in WANTED}
    missed = {db: [0] * len(METHODS) for db in WANTED}
    for scene in args.scenes or sorted((ROOT / "scenes").glob("*.pov")):
        points = results[scene.stem] = measure(scene, size, args.budget)
        cells = []
        for db in WANTED:
            times = [time_to(points.get(m, []) + points.get("none", []), db) for m in METHODS]
            missed[db] = [n + (t is None) for n, t in zip(missed[db], times)]
            if times[0] and any(times[1:]):
                ratios[db].append(times[0] / min(t for t in times[1:] if t))
            cells += ["—" if t is None else f"{1e3 * t:.0f}" for t in times]
        print(f"| {scene.stem} | " + " | ".join(cells) + " |", flush=True)
    print()
    for db, found in ratios.items():
        mean = math.exp(sum(map(math.log, found)) / len(found))
        print(f"{db:.0f} dB: adaptive sampling takes {mean:.2f} of the time of the better of methods 1 and 2, at settings "
              f"picked afterwards (geometric mean; median {statistics.median(found):.2f}), where one of these gets there at all. Not reached by any "
              f"setting: adaptive {missed[db][0]}, method 1 {missed[db][1]}, method 2 {missed[db][2]} of "
              f"{len(results)} scenes.\n")
    if args.svg:
        args.svg.parent.mkdir(parents=True, exist_ok=True)
        args.svg.write_text(plot(results))


if __name__ == "__main__":
    main()
