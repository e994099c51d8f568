#!/usr/bin/env python3
"""Measures what docs/trade.md shows and writes it there.

    benches/trade_docs.py [PART...]

The page's parts stand between `<!-- measured: PART -->` and `<!-- end -->`; without names all are measured, which
takes about an hour where truths have to be made first. GLINT names another program than target/release/glint. Build it as
Cargo.toml says: with many units of code samples and estimates take up to twice as long. All but `errors` and `others`, whose
figures hang on nothing but the program, want a machine that does nothing else.
"""

import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "trade.md"
PARTS = {
    "collection": ["benches/trade_collection.py", "--budget", "8s", "--size", "160x120", "--svg", "docs/trade/collection.svg"],
    "antialias": ["benches/antialias.py", "--size", "128x96"],
    "errors": ["benches/promises.py", "errors"],
    "others": ["benches/promises.py", "others"],
    "times": ["benches/promises.py", "times"],
    "povray": ["benches/trade_vs_povray.py", "--runs", "3", "--keep"],
    "accel": ["benches/accel.py"],
    "precision": ["cargo", "bench", "--quiet", "--bench", "precision"],
}


def main():
    chosen = sys.argv[1:] or list(PARTS)
    for part in chosen:
        if part not in PARTS:
            sys.exit(f"{part} is none of {', '.join(PARTS)}")
        print(f"measuring {part}: {' '.join(PARTS[part])}", flush=True)
        begun = time.monotonic()
        done = subprocess.run(PARTS[part], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
        print(f"{part} took {time.monotonic() - begun:.0f} s", flush=True)
        begin, end = f"<!-- measured: {part} -->\n", "<!-- end -->"
        page = PAGE.read_text()
        before, rest = page.split(begin, 1)
        _, after = rest.split(end, 1)
        PAGE.write_text(f"{before}{begin}{done.stdout.strip()}\n{end}{after}")


if __name__ == "__main__":
    main()
