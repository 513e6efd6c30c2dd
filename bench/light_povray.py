#!/usr/bin/env python3
"""light_povray.py LIGHT_CSV FOLDER_OF_SCENES [WHITTLE] — POV-Ray 3.7 on the scenes of `whittle-bench light --csv LIGHT_CSV`: time to equal error.

Every scene is exported by `whittle -o x.pov` and drawn at the same 96 x 72 pixels by one thread with 1, 4, 9, 16, 36 samples a pixel (+A0.0 +AM1 +R n); the
error is the root mean square difference of linear colour, clipped at white, from POV-Ray's own picture of 400 samples, and the time user seconds beyond those
of a picture of 4 x 3 pixels. The two programs do not draw the same picture (POV-Ray's finish has no Fresnel plastic, its area lamps are grids): each
is compared with what it would itself converge to. The table gives both programs' seconds at the error of POV-Ray's 9 samples, each line interpolated in
logarithms, by the integrator that Whittle needs least time with.
"""
import collections, csv, math, os, resource, subprocess, sys, tempfile

WIDTH, HEIGHT = 96, 72

def cpu(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime if done.returncode == 0 else None

def draw(scene, n, out, width=WIDTH, height=HEIGHT):
    quality = ['+A0.0', '+AM1', f'+R{n}', '-J'] if n > 1 else ['-A']
    return cpu(['povray', '-D', '-GA', '+WT1', f'+W{width}', f'+H{height}', '+FP16', 'File_Gamma=1.0', f'+I{scene}', f'+O{out}', *quality])

def pixels(path):
    data = open(path, 'rb').read()
    body = data[-WIDTH * HEIGHT * 6:]
    return [(body[i] * 256 + body[i + 1]) / 65535 for i in range(0, len(body), 2)]

def rms(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))

def seconds_at(points, error):
    """By the straight line, in logarithms, through the two points around `error` (or the two nearest to it)."""
    points = sorted((p for p in points if p[0] > 0 and p[1] > 0), key=lambda p: -p[1])
    if len(points) < 2:
        return None
    i = next((k for k in range(1, len(points)) if points[k][1] <= error), len(points) - 1)
    (s0, e0), (s1, e1) = points[i - 1], points[i]
    if e0 == e1:
        return s1
    return math.exp(math.log(s0) + (math.log(s1) - math.log(s0)) * (math.log(error) - math.log(e0)) / (math.log(e1) - math.log(e0)))

def main():
    rows = collections.OrderedDict()
    for r in csv.DictReader(open(sys.argv[1])):
        if r['sampler'] == 'sobol':
            rows.setdefault(r['scene'], {}).setdefault(r['integrator'], []).append((float(r['cpu_seconds']), float(r['rmse'])))
    whittle = sys.argv[3] if len(sys.argv) > 3 else 'whittle'
    print('| scene | error | POV-Ray, s | Whittle, s | by | ratio |\n|---|---|---|---|---|---|')
    for scene, lines in rows.items():
        with tempfile.TemporaryDirectory() as folder:
            pov, picture = os.path.join(folder, 'x.pov'), os.path.join(folder, 'x.ppm')
            if subprocess.run([whittle, os.path.join(sys.argv[2], scene + '.scad'), '-o', pov, '--imgsize', f'{WIDTH},{HEIGHT}', '-q'], capture_output=True).returncode != 0:
                print(f'| {scene} | – | not exported | | | |')
                continue
            reading = draw(pov, 1, picture, 4, 3)
            if reading is None or draw(pov, 20, picture) is None:
                print(f'| {scene} | – | not drawn | | | |')
                continue
            truth, points = pixels(picture), []
            for n in (1, 2, 3, 4, 6):
                spent = draw(pov, n, picture)
                points.append((max(1e-3, spent - reading), rms(pixels(picture), truth)))
        error = points[2][1]
        best = min(((seconds_at(p, error), name) for name, p in lines.items() if seconds_at(p, error)), default=None)
        if best is None or error == 0:
            print(f'| {scene} | {error:.4f} | {points[2][0]:.3f} | – | – | – |')
            continue
        print(f'| {scene} | {error:.4f} | {points[2][0]:.3f} | {best[0]:.3f} | {best[1]} | {points[2][0] / best[0]:.2f} |', flush=True)

if __name__ == '__main__':
    main()
