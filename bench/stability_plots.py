#!/usr/bin/env python3
"""stability_plots.py CSV FOLDER — tables in Markdown on standard output and one SVG an axis (stability_NAME.svg) in FOLDER."""
import collections, csv, math, os, sys

COLOURS = {'whittle': '#0b6', 'bound': '#0b6', 'povray': '#c33', 'embree': '#36c', 'openscad': '#a70'}
WIDTH, HEIGHT, LEFT, TOP, FLOOR = 460, 240, 56, 24, -20

def number(text):
    return float(text) if text else 0.0

def level(x):
    return max(FLOOR, min(1, math.log10(x))) if x > 0 else FLOOR

def plot(axis, series):
    values = sorted({v for points in series.values() for v, _ in points})
    lo, hi = math.log10(values[0]), math.log10(values[-1])
    across = lambda v: LEFT + (WIDTH - LEFT - 90) * (math.log10(v) - lo) / ((hi - lo) or 1)
    down = lambda y: TOP + (HEIGHT - TOP - 34) * (1 - (level(y) - FLOOR) / (1 - FLOOR))
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="10"><rect width="100%" height="100%" fill="#fff"/>',
           f'<text x="{LEFT}" y="14" font-size="12">median error of a border (in sizes) against {axis}</text>']
    for e in range(FLOOR, 2, 4):
        y = down(10.0 ** e)
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - 90}" stroke="#ddd"/><text x="{LEFT - 6}" y="{y + 3:.1f}" text-anchor="end">1e{e}</text>')
    for v in values[::max(1, len(values) // 7)]:
        out.append(f'<text x="{across(v):.1f}" y="{HEIGHT - 18}" text-anchor="middle">{v:.3g}</text>')
    for i, (name, points) in enumerate(series.items()):
        colour = COLOURS[name]
        dash = ' stroke-dasharray="4 3"' if name == 'bound' else ''
        path = ' '.join(f'{across(v):.1f},{down(y):.1f}' for v, y in points if y > 0)  # 0: nothing was there to compare
        out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.6"{dash}/><text x="{WIDTH - 84}" y="{TOP + 14 + 14 * i}" fill="{colour}">{name if name != "bound" else "whittle t_error"}</text>')
    return '\n'.join(out) + '\n</svg>\n'

def main():
    rows = list(csv.DictReader(open(sys.argv[1])))
    by_axis = collections.OrderedDict()
    for r in rows:
        by_axis.setdefault(r['axis'], []).append(r)
    for axis, list_ in by_axis.items():
        series = collections.OrderedDict()
        for r in list_:
            if r['program'] in ('openscad', 'no-snap'):
                continue
            series.setdefault(r['program'], []).append((float(r['value']), number(r['error_median'])))
            if r['program'] == 'whittle':
                series.setdefault('bound', []).append((float(r['value']), number(r['bound_median'])))
        name = axis.replace("'", '').replace(' ', '_')
        open(os.path.join(sys.argv[2], f'stability_{name}.svg'), 'w').write(plot(axis, series))
        print(f'## {axis[0].upper()}{axis[1:]}\n![{axis}](stability_{name}.svg)\n')
        print('| value | masked | median error | largest | median bound | outside its bound | double-double, exact per 1000 rays | wrong: Whittle | POV-Ray | Embree | OpenSCAD |\n|---|---|---|---|---|---|---|---|---|---|---|')
        for value in sorted({float(r['value']) for r in list_}):
            here = {r['program']: r for r in list_ if float(r['value']) == value}
            w = here['whittle']
            peer = lambda p: f"{100 * float(here[p]['wrong']):.4g} %" if p in here else '–'
            mesh = ('right' if float(here['openscad']['wrong']) == 0 else f"volume off by {float(here['openscad']['error_median']):.1g}") if 'openscad' in here else '–'
            if 'no-snap' in here:
                mesh += f" (Whittle with --no-snap: {peer('no-snap')} wrong)"
            print(f"| {value:.0e} | {100 * float(w['masked']):.3g} % | {float(w['error_median']):.1e} | {float(w['error_worst']):.1e} | {float(w['bound_median']):.1e} | {w['beyond_bound']} | "
                  f"{float(w['double_double_per_1000']):.3g}, {float(w['exact_per_1000']):.3g} | {peer('whittle')} | {peer('povray')} | {peer('embree')} | {mesh} |")
        print()

if __name__ == '__main__':
    main()
