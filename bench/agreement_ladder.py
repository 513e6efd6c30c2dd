#!/usr/bin/env python3
"""agreement_ladder.py WHITTLE CSV SVG [TOLERANCES] — how far meshes are from the exact solid, and what they cost, over a ladder of tolerances.

Each model is checked and meshed at tolerances halved from 0.4 mm. A chord of length h strays h^2 / (8 r) from an arc of radius r, so the tolerance is drawn as
h = sqrt(8 r t) for the model's main radius; deviations then fall as h^2, and what is drawn dashed is that slope through the coarsest point.
"""
import csv, json, math, os, resource, subprocess, sys, tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..')
MODELS = [('carved_cube', 13.5), ('pawn', 12.0), ('bearing', 20.0)]  # example, its main radius in mm
COLOURS = {'carved_cube': '#0b6', 'pawn': '#36c', 'bearing': '#c33'}
WIDTH, HEIGHT, LEFT, TOP = 340, 300, 56, 30


def cpu_of(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return done, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def row_of(whittle, model, radius, tolerance, folder):
    scene, off = os.path.join(ROOT, 'examples', model + '.scad'), os.path.join(folder, 'a.off')
    checked, check_s = cpu_of([whittle, 'check', scene, f'--tolerance={tolerance}', '--json', '-q'])
    _, mesh_s = cpu_of([whittle, 'mesh', scene, f'--tolerance={tolerance}', '-o', off, '-q'])
    answer = json.loads(checked.stdout)
    difference = answer['symmetric_difference']['volume']
    with open(off) as text:
        triangles = int(' '.join(next(text) for _ in range(2)).split()[2])  # OFF, points, facets, edges
    return {'model': model, 'tolerance_mm': tolerance, 'h_mm': math.sqrt(8 * radius * tolerance), 'agree': answer['agree'], 'difference_mm3': difference['value'],
            'difference_error': difference['error'], 'mean_mm': difference['value'] / answer['area']['mesh']['value'], 'worst_mm': answer['worst']['distance'],
            'triangles': triangles, 'mesh_cpu_s': mesh_s, 'check_cpu_s': check_s}


def panel(rows, key, title, left, slope):
    points = [(float(r['h_mm']), float(r[key]), r['model']) for r in rows if float(r[key]) > 0]
    lo, hi = (math.log10(f(p[0] for p in points)) for f in (min, max))
    floor, top = math.floor(math.log10(min(p[1] for p in points))), math.ceil(math.log10(max(p[1] for p in points)))
    across = lambda h: left + LEFT + (WIDTH - LEFT - 20) * (math.log10(h) - lo) / (hi - lo)
    down = lambda v: TOP + (HEIGHT - TOP - 40) * (top - math.log10(v)) / (top - floor)
    out = [f'<text x="{left + LEFT}" y="16" font-size="12">{title}</text>']
    for e in range(floor, top + 1):
        y = down(10.0 ** e)
        out.append(f'<path d="M{left + LEFT} {y:.1f}H{left + WIDTH - 20}" stroke="#ddd"/><text x="{left + LEFT - 6}" y="{y + 3:.1f}" text-anchor="end">{10.0 ** e:g}</text>')
    for h in (0.5, 1, 2, 5):
        if lo <= math.log10(h) <= hi:
            out.append(f'<text x="{across(h):.1f}" y="{HEIGHT - 24}" text-anchor="middle">{h:g}</text>')
    out.append(f'<text x="{left + LEFT}" y="{HEIGHT - 8}">chord length h, mm</text>')
    for i, (model, colour) in enumerate(COLOURS.items()):
        line = sorted((h, v) for h, v, m in points if m == model)
        path = ' '.join(f'{across(h):.1f},{down(v):.1f}' for h, v in line)
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.6"/><text x="{left + WIDTH - 90}" y="{HEIGHT - 80 + 13 * i}" fill="{colour}">{model}</text>')
        if slope and line:
            (h0, _), (h1, v1) = line[0], line[-1]
            v0 = v1 * (h0 / h1) ** slope
            out.append(f'<path d="M{across(h1):.1f} {down(v1):.1f}L{across(h0):.1f} {down(max(v0, 10.0 ** floor)):.1f}" stroke="{colour}" stroke-dasharray="4 3" fill="none"/>')
    return out


def slope_of(rows, model, key):
    points = [(math.log(float(r['h_mm'])), math.log(float(r[key]))) for r in rows if r['model'] == model]
    n, sx, sy = len(points), sum(p[0] for p in points), sum(p[1] for p in points)
    return (n * sum(x * y for x, y in points) - sx * sy) / (n * sum(x * x for x, _ in points) - sx * sx)


def main():
    whittle, table, drawing, steps = sys.argv[1], sys.argv[2], sys.argv[3], int((sys.argv + ['7'])[4])
    with tempfile.TemporaryDirectory() as folder:
        rows = [row_of(whittle, model, radius, 0.4 / 2 ** i, folder) for model, radius in MODELS for i in range(steps)]
    with open(table, 'w', newline='') as out:
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    parts = panel(rows, 'mean_mm', 'mean deviation, mm (dashed: slope 2)', 0, 2) + panel(rows, 'mesh_cpu_s', 'CPU seconds of whittle mesh', WIDTH, 0)
    with open(drawing, 'w') as out:
        out.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{2 * WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="10">'
                  '<rect width="100%" height="100%" fill="#fff"/>\n' + '\n'.join(parts) + '\n</svg>\n')
    for model, _ in MODELS:
        print(f"{model}: slope of the mean deviation {slope_of(rows, model, 'mean_mm'):.3f}, of the worst {slope_of(rows, model, 'worst_mm'):.3f}")


if __name__ == '__main__':
    main()
