#!/usr/bin/env python3
"""Which share of the comparisons leaves double: draws scenes and sets those that went on to double-double against all.

    bench/escalations.py WHITTLE SCENE.scad ...      one row a scene; WIDTH,HEIGHT by --imgsize, samples a pixel by --samples, seconds a scene by --limit

A comparison is the order of two events on a ray, the side of a corner or an edge, or the number of crossings with a surface that is no plane across an axis; what
is one by identity is not compared. Those of cells of axis planes and of packets are not counted, so packets are switched off and the share is at most the one
printed. Exits with 1 where one is 1e-5 or more.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

GOAL = 1e-5


def counters(whittle, scene, options):
    """The counters of one picture, or why there are none."""
    with tempfile.TemporaryDirectory() as folder:
        stats = pathlib.Path(folder) / "stats.json"
        command = [whittle, "render", str(scene), "-q", "-o", f"{folder}/picture.png", "--imgsize", options.imgsize, "--samples", str(options.samples), "--disable", "packets", "--stats", str(stats)]
        try:
            run = subprocess.run(command, capture_output=True, text=True, timeout=options.limit, check=False)
        except subprocess.TimeoutExpired:
            return f"more than {options.limit:g} s"
        if run.returncode != 0 or not stats.exists():
            lines = [line for line in run.stderr.strip().splitlines() if not line.startswith("ECHO")]
            return lines[0][:80] if lines else f"exit {run.returncode}"
        return json.loads(stats.read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("whittle")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    parser.add_argument("--imgsize", default="160,120")
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--limit", type=float, default=120)
    options = parser.parse_args()
    print("| scene | comparisons | double-double | exact | share | uncertified |\n|---|---|---|---|---|---|")
    all_compared, all_fine, all_exact, beyond = 0, 0, 0, []
    for scene in options.scenes:
        c = counters(options.whittle, scene, options)
        if isinstance(c, str):
            print(f"| {scene.name} | {c} | | | | |", flush=True)
            continue
        fine, exact = c["spans.escalated.double_double"], c["spans.escalated.exact"]
        compared = c["skip.filter"] + fine
        share = fine / compared if compared else 0
        print(f"| {scene.name} | {compared:,} | {fine:,} | {exact:,} | {f'{share:.1e}' if fine else 0} | {c['spans.uncertified']:,} |", flush=True)
        all_compared, all_fine, all_exact = all_compared + compared, all_fine + fine, all_exact + exact
        if share >= GOAL:
            beyond.append(scene.name)
    print(f"| all | {all_compared:,} | {all_fine:,} | {all_exact:,} | {all_fine / max(1, all_compared):.1e} | |")
    if beyond:
        print("at or beyond the goal:", ", ".join(beyond), file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
