#!/usr/bin/env python3
"""stability_plots.py CSV FOLDER — tables in Markdown on standard output and one SVG an axis (stability_NAME.svg) in FOLDER."""
import collections, csv, math, os, sys

COLOURS = {'whittle': '#0b6', 'bound': '#0b6', 'povray': '#c33', 'embree': '#36c', 'openscad': '#a70', 'masked': '#888', 'double-double': '#808', 'exact': '#e0e'}
NAMES = {'bound': 'whittle t_error', 'masked': 'masked rays', 'double-double': 'to double-double', 'exact': 'to exact'}
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 460, 240, 56, 100, 24, 34

def number(text):
    return float(text) if text else 0.0

class Panel:
    """Curves over one axis, both ways logarithmic; what is 0 lies on the floor."""
    def __init__(self, x, title, values, floor, top, step):
        self.x, self.values, self.floor, self.top = x, values, floor, top
        self.out = [f'<text x="{x + LEFT}" y="14" font-size="12">{title}</text>']
        self.names = []
        for e in range(floor, top + 1, step):
            y = self.down(10.0 ** e)
            name = '0' if e == floor and top == 0 else f'1e{e}'
            self.out.append(f'<path d="M{x + LEFT} {y:.1f}H{x + WIDTH - RIGHT}" stroke="#ddd"/><text x="{x + LEFT - 6}" y="{y + 3:.1f}" text-anchor="end">{name}</text>')
        for v in values[::max(1, len(values) // 7)]:
            self.out.append(f'<text x="{self.across(v):.1f}" y="{HEIGHT - 18}" text-anchor="middle">{v:.3g}</text>')

    def across(self, v):
        lo, hi = math.log10(self.values[0]), math.log10(self.values[-1])
        return self.x + LEFT + (WIDTH - LEFT - RIGHT) * (math.log10(v) - lo) / ((hi - lo) or 1)

    def down(self, y):
        level = max(self.floor, min(self.top, math.log10(y))) if y > 0 else self.floor
        return TOP + (HEIGHT - TOP - BOTTOM) * (1 - (level - self.floor) / (self.top - self.floor))

    def curve(self, name, points, dashed):
        path = ' '.join(f'{self.across(v):.1f},{self.down(y):.1f}' for v, y in points)
        dash = ' stroke-dasharray="4 3"' if dashed else ''
        at = f'x="{self.x + WIDTH - RIGHT + 6}" y="{TOP + 14 + 14 * len(self.names)}"'
        self.out.append(f'<polyline points="{path}" fill="none" stroke="{COLOURS[name]}" stroke-width="1.6"{dash}/><text {at} fill="{COLOURS[name]}">{NAMES.get(name, name)}</text>')
        self.names.append(name)

def series_of(rows):
    """Errors by program (0: nothing was there to compare, left out), and shares."""
    errors, shares = collections.OrderedDict(), collections.OrderedDict()
    for r in rows:
        at = float(r['value'])
        if r['program'] == 'no-snap':
            continue
        shares.setdefault(r['program'], []).append((at, number(r['wrong'])))
        if r['program'] == 'whittle':
            for name, share in (('masked', number(r['masked'])), ('double-double', number(r['double_double_per_1000']) / 1000), ('exact', number(r['exact_per_1000']) / 1000)):
                shares.setdefault(name, []).append((at, share))
        for name, column in (('bound', 'bound_median'), (r['program'], 'error_median')):
            if r['program'] != 'openscad' and number(r[column]) > 0:
                errors.setdefault(name, []).append((at, number(r[column])))
    return errors, shares

def plot(axis, rows):
    values = sorted({float(r['value']) for r in rows})
    errors, shares = series_of(rows)
    left = Panel(0, f'median error of a border (in sizes) against {axis}', values, -20, 1, 4)
    for name, points in errors.items():
        left.curve(name, sorted(points), name == 'bound')
    right = Panel(WIDTH, 'shares of the rays: wrong by program, masked, escalations a ray', values, -5, 0, 1)
    for name, points in shares.items():
        right.curve(name, sorted(points), name in ('masked', 'double-double', 'exact'))
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{2 * WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="10"><rect width="100%" height="100%" fill="#fff"/>'
    return '\n'.join([head] + left.out + right.out) + '\n</svg>\n'

def main():
    rows = list(csv.DictReader(open(sys.argv[1])))
    by_axis = collections.OrderedDict()
    for r in rows:
        by_axis.setdefault(r['axis'], []).append(r)
    for axis, list_ in by_axis.items():
        name = axis.replace("'", '').replace(' ', '_')
        open(os.path.join(sys.argv[2], f'stability_{name}.svg'), 'w').write(plot(axis, list_))
        print(f'### {axis[0].upper()}{axis[1:]}\n![{axis}](stability_{name}.svg)\n')
        print('| value | masked | median error | largest | median bound | outside its bound | double-double, exact per 1000 rays | wrong: Whittle | POV-Ray | Embree | OpenSCAD |\n|---|---|---|---|---|---|---|---|---|---|---|')
        for value in sorted({float(r['value']) for r in list_}):
            here = {r['program']: r for r in list_ if float(r['value']) == value}
            w = here['whittle']
            peer = lambda p: f"{100 * float(here[p]['wrong']):.4g} %" if p in here else '–'
            mesh = ('right' if float(here['openscad']['wrong']) == 0 else f"volume off by {float(here['openscad']['error_median']):.1g}") if 'openscad' in here else '–'
            if 'no-snap' in here:
                n = here['no-snap']
                mesh += f" (Whittle with --no-snap: {peer('no-snap')} wrong, error {number(n['error_median']):.1e}, to double-double {number(n['double_double_per_1000']):.3g} in 1000)"
            print(f"| {value:.0e} | {100 * float(w['masked']):.3g} % | {float(w['error_median']):.1e} | {float(w['error_worst']):.1e} | {float(w['bound_median']):.1e} | {w['beyond_bound']} | "
                  f"{float(w['double_double_per_1000']):.3g}, {float(w['exact_per_1000']):.3g} | {peer('whittle')} | {peer('povray')} | {peer('embree')} | {mesh} |")
        print()

if __name__ == '__main__':
    main()
