#!/usr/bin/env python3
"""ray_plots.py CSV SVG [QUERY] [RAYS] — what `whittle-bench rays --csv` wrote, as bars: a group a scene, a bar a subject, million rays a second on a logarithmic scale."""
import collections, csv, math, sys

COLOURS = {'whittle packets': '#0b6', 'whittle ray': '#7c9', 'embree 1': '#9bd', 'embree 16': '#36c', 'pov-ray flat': '#c33', 'pov-ray bounded': '#e88', 'pov-ray by hand': '#a55'}
BAR, GAP, LEFT, TOP, HEIGHT, FLOOR = 13, 16, 46, 40, 220, -3

def kind(subject):
    return next((name for name in COLOURS if subject == name or subject.startswith(name + ' (')), None)

def main():
    query, rays = (sys.argv[3:] + ['first', 'camera'][len(sys.argv) - 3:])[:2]
    scenes = collections.OrderedDict()
    for r in csv.DictReader(open(sys.argv[1])):
        if (r['query'], r['rays']) == (query, rays) and kind(r['subject']):
            scenes.setdefault(r['scene'], []).append((kind(r['subject']), *(float(r['mray_s_' + q]) for q in ('median', 'lower', 'upper'))))
    top = math.ceil(max(math.log10(row[3]) for rows in scenes.values() for row in rows))
    down = lambda v: TOP + HEIGHT * (1 - (max(FLOOR, math.log10(v)) - FLOOR) / (top - FLOOR))
    out, x = [], LEFT + GAP
    for scene, rows in scenes.items():
        middle = x + BAR * len(rows) / 2
        for name, median, lower, upper in rows:
            out.append(f'<rect x="{x}" y="{down(median):.1f}" width="{BAR - 2}" height="{TOP + HEIGHT - down(median):.1f}" fill="{COLOURS[name]}"/>'
                       f'<path d="M{x + (BAR - 2) / 2} {down(lower):.1f}V{down(upper):.1f}" stroke="#000"/>')
            x += BAR
        out.append(f'<text x="{middle}" y="{TOP + HEIGHT + 14}" text-anchor="middle">{scene}</text>')
        x += GAP
    grid = [f'<path d="M{LEFT} {down(10.0 ** e):.1f}H{x}" stroke="#ddd"/><text x="{LEFT - 6}" y="{down(10.0 ** e) + 3:.1f}" text-anchor="end">{10.0 ** e:g}</text>' for e in range(FLOOR, top + 1)]
    legend = [f'<text x="{LEFT + 110 * (i % 4)}" y="{14 + 13 * (i // 4)}" fill="{c}">{name}</text>' for i, (name, c) in enumerate(COLOURS.items())]
    open(sys.argv[2], 'w').write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{max(x, 520)}" height="{TOP + HEIGHT + 24}" font-family="sans-serif" font-size="10"><rect width="100%" height="100%" fill="#fff"/>\n'
                                 + '\n'.join(grid + out + legend) + '\n</svg>\n')

if __name__ == '__main__':
    main()
