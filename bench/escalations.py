#!/usr/bin/env python3
"""Which share of the work leaves double: renders scenes and sets the steps to double-double and exact against the shapes asked.

    bench/escalations.py WHITTLE SCENE.scad ...      one row a scene; WIDTH,HEIGHT by --imgsize, seconds a scene by --limit

A shape asked costs at least one comparison, so the share of comparisons is at most the one printed.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile


def counters(whittle, scene, size, limit):
    """The counters of one picture, or why there are none."""
    with tempfile.TemporaryDirectory() as folder:
        stats = pathlib.Path(folder) / "stats.json"
        command = [whittle, "render", str(scene), "-o", f"{folder}/picture.png", "--imgsize", size, "--samples", "1", "--stats", str(stats)]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return f"more than {limit} s"
        if run.returncode != 0 or not stats.exists():
            lines = run.stderr.strip().splitlines()
            return lines[0][:80] if lines else f"exit {run.returncode}"
        return json.loads(stats.read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("whittle")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--imgsize", default="320,240")
    parser.add_argument("--limit", type=float, default=60)
    options = parser.parse_args()
    print("| scene | shapes asked | double-double | exact | share | uncertified |\n|---|---|---|---|---|---|")
    for scene in options.scenes:
        c = counters(options.whittle, scene, options.imgsize, options.limit)
        if isinstance(c, str):
            print(f"| {scene.name} | {c} | | | | |", flush=True)
            continue
        asked, fine, exact = c["primitives.tests"], c["spans.escalated.double_double"], c["spans.escalated.exact"]
        share = f"{(fine + exact) / asked:.1e}" if asked else "–"
        print(f"| {scene.name} | {asked:,} | {fine:,} | {exact:,} | {share} | {c['spans.uncertified']:,} |", flush=True)


if __name__ == "__main__":
    main()
