#!/usr/bin/env python3
"""How often do the intervals of `whittle measure` hold the truth?

    bench/measure_coverage.py build/release/whittle FILE --volume V --area A [--runs 1000]

One run for each seed 0, 1, ...; prints the share of runs whose interval of volume and of area holds the truth, the mean relative error in its own standard errors
(the bias), the median, the error that 99 % of runs stay below, and the largest.
"""
import argparse
import json
import math
import subprocess


def measured(program, file, seed):
    done = subprocess.run([program, "measure", file, "--json", "--threads", "1", "--seed", str(seed)], capture_output=True, check=True, text=True)
    return json.loads(done.stdout)


def line(name, values, truth):
    errors = [(v["value"] - truth) / truth for v in values]
    held = sum(abs(v["value"] - truth) <= v["error"] for v in values)
    n = len(errors)
    mean = sum(errors) / n
    deviation = math.sqrt(sum((e - mean) ** 2 for e in errors) / max(1, n - 1) / n)
    sizes = sorted(abs(e) for e in errors)
    kinds = "/".join(sorted({v["kind"] for v in values}))
    return (f"{name} ({kinds}): {n} runs, held {100 * held / n:.1f} %, mean {mean:.2g} ({mean / deviation if deviation else 0:+.1f} of its standard error), "
            f"median {sizes[n // 2]:.2g}, 99 % below {sizes[min(n - 1, math.ceil(0.99 * n) - 1)]:.2g}, largest {sizes[-1]:.2g}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("file")
    parser.add_argument("--volume", type=float, required=True)
    parser.add_argument("--area", type=float, required=True)
    parser.add_argument("--runs", type=int, default=1000)
    asked = parser.parse_args()
    runs = [measured(asked.program, asked.file, seed) for seed in range(asked.runs)]
    print(line("volume", [r["volume"] for r in runs], asked.volume))
    print(line("area", [r["area"] for r in runs], asked.area))


if __name__ == "__main__":
    main()
