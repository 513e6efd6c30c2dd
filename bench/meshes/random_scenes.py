#!/usr/bin/env python3
"""random_scenes.py FOLDER COUNT [SEED] — random set trees as .scad files, for `whittle check --suite FOLDER` and for OpenSCAD beside it.

Sizes and places are multiples of 1/2 and most turns of 90 degrees, so that faces, edges and corners coincide often, as people's models do; every third tree has one
subtree turned by an odd angle, used twice. Same seed, same bytes.
"""
import os, random, sys

LEAVES = 12  # at most


def number(r, lo, hi):
    return r.randint(2 * lo, 2 * hi) / 2


def leaf(r):
    a, b, c = (max(0.5, number(r, 1, 4)) for _ in range(3))
    centre = r.choice(['true', 'false'])
    return r.choice([
        f'cube([{a}, {b}, {c}], center = {centre});',
        f'cube({a}, center = {centre});',
        f'sphere({a});',
        f'cylinder(h = {a}, r = {b / 2}, center = {centre});',
        f'cylinder(h = {a}, r1 = {b / 2}, r2 = {c / 4}, center = {centre});',
        f'rotate_extrude() translate([{a + b / 2}, 0]) circle({b / 2});',
        f'rotate_extrude() translate([{a / 2}, 0]) square([{b / 2}, {c}]);',
        f'linear_extrude({a}) difference() {{ square([{b + 1}, {c + 1}]); translate([0.5, 0.5]) square([{b / 2}, {c / 2}]); }}',
        f'linear_extrude({a}) offset(r = 0.5) square([{b}, {c}]);',
        f'hull() {{ cube({a}); translate([{b}, 0, {c}]) cube({a / 2}); }}',
    ])


def moved(r):
    turn = [r.choice([0, 90, 180, 270]) if r.random() < 0.3 else 0 for _ in range(3)]
    out = f'translate([{number(r, -2, 2)}, {number(r, -2, 2)}, {number(r, -2, 2)}]) '
    return out + (f'rotate({turn}) ' if any(turn) else '')


def tree(r, leaves, pad):
    if leaves == 1:
        return pad + moved(r) + leaf(r) + '\n'
    operation = r.choices(['union', 'difference', 'intersection'], [5, 4, 2])[0]
    first = r.randint(1, leaves - 1)
    parts = [first, leaves - first] if leaves < 4 or r.random() < 0.5 else [first] + [1] * (leaves - first)
    out = pad + (moved(r) if r.random() < 0.5 else '') + operation + '() {\n'
    for n in parts:
        out += tree(r, n, pad + '    ')
    return out + pad + '}\n'


def scene(r, index):
    text = tree(r, r.randint(2, LEAVES), '')
    if index % 3 == 2:
        turn = [r.randint(1, 89), r.randint(1, 89), r.randint(1, 89)]
        text = 'module part() {\n' + tree(r, r.randint(1, 4), '    ') + '}\n' + text + f'rotate({turn}) {{ part(); translate([{number(r, 1, 3)}, 0, 0]) part(); }}\n'
    return text


def main():
    folder, count, seed = sys.argv[1], int(sys.argv[2]), int((sys.argv + ['1'])[3])
    os.makedirs(folder, exist_ok=True)
    for i in range(count):
        with open(os.path.join(folder, f'tree{i:03}.scad'), 'w') as out:
            out.write(f'// Tree {i} of random_scenes.py, seed {seed}.\n' + scene(random.Random(seed * 100003 + i), i))


if __name__ == '__main__':
    main()
