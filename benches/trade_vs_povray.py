#!/usr/bin/env python3
"""Time against error, Glint beside POV-Ray: six scenes, each renderer against its own converged picture.

    benches/trade_vs_povray.py [--runs N] [--scene NAME] [--keep] [--json FILE]

For each scene POV-Ray renders over a grid of anti-aliasing settings and Glint over a row of --max-error, one
thread each. A picture's error is its RMSE in linear light clipped to 0..1 against the converged picture of its
own renderer: POV-Ray's with +AM1 +A0.0 +R9 -J, Glint's with 256 stratified samples in every pixel and other
random numbers. Times are CPU seconds of tracing: POV-Ray's own statistics, Glint's --json; the least of the runs.
Settings of POV-Ray's that cannot be its quickest are left out: those that are at least as fine in threshold and
depth as one of the same method that took longer than another which was good enough. Of both renderers those that may
be the quickest are timed again in turns at the end, so that what else the machine does falls on both.

Printed: seconds to reach 40 dB (POV-Ray: the quickest setting of the grid that reaches it; Glint: the quickest
of its row), and what Glint reaches in the time that POV-Ray's takes. GLINT and POVRAY name other programs.
Pictures are kept in target/trade; converged ones are made once. So is POV-Ray's grid with --keep, which changes with
nothing of ours: then only its settings that may be the quickest are timed anew, and the least of all times counts.
"""

import argparse
import json
import math
import os
import re
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "target" / "trade"
GLINT = os.environ.get("GLINT", str(ROOT / "target" / "release" / "glint"))
POVRAY = os.environ.get("POVRAY", "povray")

# Name, scene, width, height, declared number.
SCENES = [
    ("horizon", "benches/scenes/trade/horizon.pov", 320, 240, None),
    ("sphereflake", "benches/scenes/sphereflake.pov", 320, 240, "Depth=4"),
    ("still life", "benches/scenes/trade/still_life.pov", 320, 240, None),
    ("machine part", "benches/scenes/trade/machine.pov", 320, 240, None),
    ("landscape", "benches/scenes/trade/landscape.pov", 320, 240, None),
    ("room", "benches/scenes/trade/room.pov", 320, 240, None),
]

# Method, threshold, depth.
POVRAY_GRID = [
    (1, 0.3, 2), (1, 0.3, 3), (1, 0.1, 3), (1, 0.1, 4), (1, 0.03, 3), (1, 0.03, 5), (1, 0.0, 4), (1, 0.0, 6),
    (2, 0.3, 2), (2, 0.3, 3), (2, 0.1, 2), (2, 0.1, 3), (2, 0.1, 4), (2, 0.03, 3), (2, 0.03, 4), (2, 0.0, 4),
]
GLINT_ROW = [0.03, 0.02, 0.017, 0.0162, 0.0155, 0.0148, 0.0142, 0.0136, 0.013, 0.0124, 0.0118, 0.0112, 0.0107, 0.0102, 0.0097, 0.0092,
             0.0085, 0.0075, 0.006, 0.005, 0.0035, 0.0025]
WANTED_DB = 40.0
# How much longer than the quickest a setting may have taken to be timed again, and how many are at most.
MAY_BE_QUICKEST, CANDIDATES = 1.25, 4


def povray(scene, output, width, height, declared, words):
    """CPU seconds of tracing."""
    command = [POVRAY, f"+I{scene.name}", f"+O{output}", f"+W{width}", f"+H{height}", "-D", "+WT1",
               "Bits_Per_Color=16", *words] + ([f"Declare={declared}"] if declared else [])
    done = subprocess.run(command, cwd=scene.parent, capture_output=True, text=True, errors="replace")
    if done.returncode:
        sys.exit(f"POV-Ray failed: {' '.join(command)}\n{done.stderr[-2000:]}")
    text = done.stderr[done.stderr.index("Trace Time:"):]
    return float(re.search(r"with ([0-9.]+) CPU-seconds", text).group(1))


def glint(scene, output, width, height, declared, words):
    """What --json says."""
    command = [GLINT, "render", str(scene), "-o", str(output), "-W", str(width), "-H", str(height),
               "--threads", "1", "--bits", "16", "--json", "-q", *words]
    done = subprocess.run(command + (["-D", declared] if declared else []), capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"Glint failed: {' '.join(command)}\n{done.stderr}")
    return json.loads(done.stdout)


def decibels(a, b):
    done = subprocess.run([GLINT, "compare", str(a), str(b), "--json"], capture_output=True, text=True, check=True)
    db = json.loads(done.stdout)["light"]["psnr_db"]
    return math.inf if db is None else db


def measure(name, path, width, height, declared, runs, keep):
    scene = ROOT / path
    base = WORK / name.replace(" ", "_")
    place = (width, height, declared)
    truths = {who: base.with_name(f"{base.name}_{who}_{width}.png") for who in ("povray", "glint")}
    if not truths["povray"].exists():
        povray(scene, truths["povray"], *place, ["+AM1", "+A0.0", "+R9", "-J"])
    if not truths["glint"].exists():
        glint(scene, truths["glint"], *place, ["--min-samples", "256", "--seed", "77"])
    agree = decibels(truths["povray"], truths["glint"])
    output = base.with_name(f"{base.name}_now.png")
    grid = base.with_name(f"{base.name}_povray_{width}.json")
    if keep and grid.exists():
        rows = {"povray": [tuple(row) for row in json.loads(grid.read_text())], "glint": []}
    else:
        rows = {"povray": povray_grid(scene, output, place, truths["povray"]), "glint": []}
        grid.write_text(json.dumps(rows["povray"]))
    for error in GLINT_ROW:
        words = [f"--max-error={error}"]
        seconds = min(glint(scene, output, *place, words)["trace_cpu_s"] for _ in range(2))
        rows["glint"].append((seconds, decibels(output, truths["glint"]), words[0]))
    again(rows, runs, {
        "povray": lambda words: povray(scene, output, *place, words),
        "glint": lambda words: glint(scene, output, *place, words)["trace_cpu_s"],
    })
    if keep:
        grid.write_text(json.dumps(rows["povray"]))
    return {"scene": name, "agree_db": agree, **rows}


def povray_grid(scene, output, place, truth):
    """Seconds, decibels and words of POV-Ray's settings."""
    rows, slow = [], []
    for method, threshold, depth in POVRAY_GRID:
        if any(m == method and threshold <= t and depth >= d for m, t, d in slow):
            continue
        words = [f"+AM{method}", f"+A{threshold}", f"+R{depth}", "-J"]
        seconds = povray(scene, output, *place, words)
        rows.append((seconds, decibels(output, truth), " ".join(words)))
        best = quickest(rows)
        if best and seconds > 1.2 * best[0]:
            slow.append((method, threshold, depth))
    return rows


def again(rows, runs, render):
    """Times both renderers' settings that may be the quickest once more, in turns."""
    for _ in range(runs):
        for who, found in rows.items():
            good = sorted(r for r in found if r[1] >= WANTED_DB)
            for _, _, words in [r for r in good if r[0] <= MAY_BE_QUICKEST * good[0][0]][:CANDIDATES]:
                seconds = render[who](words.split())
                rows[who] = [(min(r[0], seconds), *r[1:]) if r[2] == words else r for r in rows[who]]


def quickest(rows):
    """The least time that reaches what is wanted, or None."""
    return min((r for r in rows if r[1] >= WANTED_DB), default=None)


def at_time(rows, seconds):
    """Decibels after so many seconds, between the points of a row that no other beats."""
    front, best = [], -math.inf
    for row in sorted(rows):
        if row[1] > best:
            front.append(row)
            best = row[1]
    below = [r for r in front if r[0] <= seconds]
    above = [r for r in front if r[0] > seconds]
    if not below:
        return None
    if not above:
        return below[-1][1]
    (t0, d0, _), (t1, d1, _) = below[-1], above[0]
    share = math.log(seconds / t0) / math.log(t1 / t0)
    return d0 + share * (d1 - d0)


def line(result):
    p, g = quickest(result["povray"]), quickest(result["glint"])
    if p is None:
        best = max(result["povray"], key=lambda r: r[1])
        p, reached = best, f"> {best[0]:.2f} ({best[1]:.1f} dB at best)"
    else:
        reached = f"{p[0]:.2f}"
    then = at_time(result["glint"], p[0])
    ratio = g[0] / p[0] if g else math.inf
    more = then - p[1] if then is not None else -math.inf
    text = (f"| {result['scene']} | {result['agree_db']:.1f} | {reached} | {p[2]} | {p[1]:.1f} | "
            f"{g[0] if g else math.nan:.3f} | {g[1] if g else math.nan:.1f} | {ratio:.3f} | {more:+.1f} |")
    return text, ratio, more


def main():
    parser = argparse.ArgumentParser(description="Time against error, Glint beside POV-Ray.")
    parser.add_argument("--runs", type=int, default=2)
    parser.add_argument("--scene", action="append", help="only this one")
    parser.add_argument("--keep", action="store_true", help="POV-Ray's grid is measured once")
    parser.add_argument("--json", type=Path, help="keep every point here")
    args = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    print("| scene | converged pictures agree (dB) | POV-Ray, s to 40 dB | its setting | dB | "
          "Glint, s to 40 dB | dB | ratio | dB more at equal time |")
    print("|---|---|---|---|---|---|---|---|---|")
    results, ratios, gains = [], [], []
    for scene in SCENES:
        if args.scene and scene[0] not in args.scene:
            continue
        result = measure(*scene, args.runs, args.keep)
        results.append(result)
        text, ratio, more = line(result)
        print(text, flush=True)
        ratios.append(ratio)
        gains.append(more)
    mean = math.exp(sum(map(math.log, ratios)) / len(ratios))
    print(f"\nRatio: geometric mean {mean:.3f}, largest {max(ratios):.3f}. "
          f"At equal time: median {statistics.median(gains):+.1f} dB, least {min(gains):+.1f} dB.")
    if args.json:
        args.json.write_text(json.dumps(results, indent=1))


if __name__ == "__main__":
    main()
