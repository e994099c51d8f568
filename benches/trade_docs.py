#!/usr/bin/env python3
"""Measures what docs/trade.md shows and writes it there.

    benches/trade_docs.py [PART...]

The page's parts stand between `<!-- measured: PART -->` and `<!-- end -->`; without names all are measured, which
takes about an hour. GLINT names another program than target/release/glint.
"""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "trade.md"
PARTS = {
    "collection": ["benches/trade_collection.py", "--budget", "8s", "--size", "160x120", "--svg", "docs/trade/collection.svg"],
    "antialias": ["benches/antialias.py", "--size", "128x96"],
    "errors": ["benches/promises.py", "errors"],
    "others": ["benches/promises.py", "others"],
    "times": ["benches/promises.py", "times"],
    "povray": ["benches/trade_vs_povray.py", "--runs", "3"],
    "accel": ["benches/accel.py"],
    "precision": ["cargo", "bench", "--quiet", "--bench", "precision"],
}


def main():
    chosen = sys.argv[1:] or list(PARTS)
    for part in chosen:
        if part not in PARTS:
            sys.exit(f"{part} is none of {', '.join(PARTS)}")
        print(f"measuring {part}: {' '.join(PARTS[part])}", flush=True)
        done = subprocess.run(PARTS[part], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
        begin, end = f"<!-- measured: {part} -->\n", "<!-- end -->"
        page = PAGE.read_text()
        before, rest = page.split(begin, 1)
        _, after = rest.split(end, 1)
        PAGE.write_text(f"{before}{begin}{done.stdout.strip()}\n{end}{after}")


if __name__ == "__main__":
    main()
