#!/usr/bin/env python3
"""compare_commits.py BEFORE AFTER [-- WORDS OF whittle-bench rays] — two commits, built apart, raced in one run; their ratio with its spread.

Each commit is checked out into a worktree of its own below --folder (kept between runs: the second comparison with one commit builds little) and built with
WHITTLE_BENCH. Then both programs take turns, one round each, with the first to go changing every round; every row of `whittle-bench rays` that both print
is compared by the ratio after/before of its speed within a pair: the median, the quartiles, and in how many pairs the later commit was faster.

    bench/compare_commits.py HEAD~1 HEAD -- --scenes S1,S2,S6 --queries first --rays camera --only whittle
    bench/compare_commits.py main HEAD --rounds 15 --program 'render examples/menger.scad --imgsize 320,240 --threads 1 -q -o {out}.png'

    bench/compare_commits.py HEAD HEAD --later-options=-DWHITTLE_CERTIFICATES=OFF -- --only whittle     (what the bounds of errors cost)

With --program the words are whittle's own, and what is compared is processor time ({out} is a name in a folder of that commit).
"""
import argparse, csv, os, resource, statistics, subprocess, sys, tempfile

def run(words, **options):
    return subprocess.run(words, check=True, **options)

def build(commit, folder, jobs, target, cmake_options):
    name = subprocess.run(['git', 'rev-parse', '--short=12', commit + '^{commit}'], check=True, capture_output=True, text=True).stdout.strip()
    tree = os.path.join(folder, name)
    if not os.path.isdir(tree):
        run(['git', 'worktree', 'add', '--detach', '--quiet', tree, name])
    # As deep as the preset's own folder: a compiler cache then knows what other checkouts have compiled.
    out = os.path.join(tree, 'build', 'release' + ''.join(cmake_options).replace('/', '_'))
    here = {**os.environ, 'CCACHE_BASEDIR': tree}
    run(['cmake', '--preset', 'release', '-B', out, '-DWHITTLE_BENCH=ON', '-DWHITTLE_TESTS=OFF', *cmake_options], stdout=subprocess.DEVNULL, cwd=tree, env=here)
    run(['ninja', '-C', out, f'-j{jobs}', target], stdout=subprocess.DEVNULL, env=here)
    return ' '.join([name, *cmake_options]), out

# Rows of one round by their name; greater is faster.
def round_of_rays(out, words):
    with tempfile.NamedTemporaryFile(suffix='.csv') as rows:
        run([os.path.join(out, 'whittle-bench'), 'rays', *words, '--rounds', '1', '--csv', rows.name], stdout=subprocess.DEVNULL)
        return {' '.join((r['scene'], r['query'], r['rays'], r['subject'])): float(r['mray_s_median']) for r in csv.DictReader(open(rows.name))}

def round_of_program(out, words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run([os.path.join(out, 'whittle'), *(w.replace('{out}', os.path.join(out, 'compared')) for w in words)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {'processor time': 1 / (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)}

def quartiles(values):
    return statistics.quantiles(values, n=4, method='inclusive') if len(values) > 1 else [values[0]] * 3

def main():
    arguments, words = sys.argv[1:], []
    if '--' in arguments:
        at = arguments.index('--')
        arguments, words = arguments[:at], arguments[at + 1:]
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[0])
    parser.add_argument('before')
    parser.add_argument('after')
    parser.add_argument('--rounds', type=int, default=9)
    parser.add_argument('--jobs', type=int, default=os.cpu_count())
    parser.add_argument('--folder', default=os.path.join(tempfile.gettempdir(), 'whittle-compared'))
    parser.add_argument('--later-options', default='', help='for cmake, of the second of them')
    parser.add_argument('--program', help="words for whittle instead of whittle-bench rays")
    options = parser.parse_args(arguments)
    if options.rounds < 1:
        parser.error('--rounds is at least 1')
    os.makedirs(options.folder, exist_ok=True)
    target = 'whittle' if options.program else 'whittle-bench'
    try:
        (before, old), (after, new) = (build(c, options.folder, options.jobs, target, more)
                                        for c, more in ((options.before, []), (options.after, options.later_options.split())))
        ratios = {}
        for i in range(options.rounds):
            speeds = {}
            for out in (old, new) if i % 2 == 0 else (new, old):
                speeds[out] = round_of_program(out, options.program.split()) if options.program else round_of_rays(out, words)
            for row in speeds[old]:
                if row in speeds[new]:
                    ratios.setdefault(row, []).append(speeds[new][row] / speeds[old][row])
    except subprocess.CalledProcessError as fault:
        sys.exit(f'{" ".join(fault.cmd)}: exit code {fault.returncode}' + (f'\n{fault.stderr}' if fault.stderr else ''))
    print(f'{after} over {before}, {options.rounds} alternating rounds; above 1: the later is faster')
    for row, values in ratios.items():
        lower, median, upper = quartiles(values)
        faster = sum(v > 1 for v in values)
        print(f'{row:60} x{median:.3f} ({lower:.3f} - {upper:.3f})  faster in {faster} of {len(values)}' + ('' if lower <= 1 <= upper else '  *'))

if __name__ == '__main__':
    main()
