#!/usr/bin/env python3
"""light_effects.py WHITTLE [FOLDER] [ROUNDS] [EFFECT,EFFECT] — five effects of light, by Whittle and by POV-Ray 3.7 on the same exported scenes: processor time to equal error.

Every scene of FOLDER (bench/light) is exported by `whittle -o x.pov` and drawn at 160 x 120 pixels by one thread. Both programs are asked at rising quality, by turns;
a time is the least user time of the rounds less that of a picture of 4 x 3 pixels; an error is the root mean square difference of linear colour, clipped at
white, from what the same program converges to. POV-Ray has its choice: supersampling (+AM1), adaptive supersampling (+AM2), several grids of an area lamp, blur
samples, photons. Whittle has the integrator named here, samples, photons, and the noise at which a pixel is good enough (--noise, its counterpart of +A). Of both
programs' settings those count that no other beats in time and error. Both weigh a pixel's samples alike, by a box (--filter box), as POV-Ray always does. What they
converge to has no sample in common with what is measured: more and other places in a pixel, a finer grid of lamps, more photons. Caustics are drawn twice, by Whitted's tree with photons, which is what POV-Ray does, and by paths from the eye and the lamp, which also follow
light between dull surfaces. The table compares both at three errors: those of POV-Ray's settings a third and two thirds along its own line and at its end.
"""
import array, itertools, math, os, re, resource, struct, subprocess, sys, tempfile, zlib

WIDTH, HEIGHT = 160, 120
# Effect and integrator; the effect is a scene's name.
EFFECTS = [('reflection', 'whitted'), ('refraction', 'whitted'), ('soft_shadow', 'distributed'), ('photons', 'whitted'), ('photons', 'caustics'), ('focal_blur', 'distributed')]
MOST_SAMPLES = {'refraction': 64, 'photons': 64}

def cpu(words):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(' '.join(words) + '\n' + done.stderr)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before.ru_utime

def clipped(numbers):
    return [min(1.0, max(0.0, x)) for x in numbers]

def pixels(path):
    return exr_pixels(open(path, 'rb').read()) if path.endswith('.exr') else ppm_pixels(open(path, 'rb').read())

def ppm_pixels(data):
    """Of 16 bits a number."""
    numbers = array.array('H', data[-6 * WIDTH * HEIGHT:])
    if sys.byteorder == 'little':
        numbers.byteswap()
    return [x / 65535 for x in numbers]

def exr_pixels(data):
    """R, G and B of a file of halves, sixteen rows packed by deflate: what Whittle writes."""
    at, channels, compression = 8, [], None
    while data[at]:
        name, kind, rest = data[at:].split(b'\0', 2)
        at += len(name) + len(kind) + 2
        size, = struct.unpack_from('<i', data, at)
        value, at = data[at + 4:at + 4 + size], at + 4 + size
        if name == b'compression':
            compression = value[0]
        while name == b'channels' and len(value) > 1:
            channel, value = value.split(b'\0', 1)
            if struct.unpack_from('<i', value)[0] != 1:
                sys.exit('a picture whose numbers are no halves')
            channels.append(channel)
            value = value[16:]
    if compression != 3:
        sys.exit('a picture packed otherwise')
    planes = {c: [] for c in channels}
    for offset in struct.unpack_from(f'<{(HEIGHT + 15) // 16}Q', data, at + 1):
        y, size = struct.unpack_from('<ii', data, offset)
        rows = min(16, HEIGHT - y)
        raw, block = 2 * WIDTH * rows * len(channels), data[offset + 8:offset + 8 + size]
        if size < raw:
            # Two halves, each byte the difference from the one before and 128.
            split = bytes(x & 255 for x in itertools.accumulate(zlib.decompress(block), lambda a, b: a + b - 128))
            block = bytes(b for pair in itertools.zip_longest(split[:(raw + 1) // 2], split[(raw + 1) // 2:], fillvalue=0) for b in pair)[:raw]
        for row in range(rows):
            for k, channel in enumerate(channels):
                planes[channel] += struct.unpack_from(f'<{WIDTH}e', block, 2 * WIDTH * (row * len(channels) + k))
    return clipped(x for triple in zip(planes[b'R'], planes[b'G'], planes[b'B']) for x in triple)

def rms(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a))

class Whittle:
    # Reads the scene and little else.
    idle = (1, ['--integrator', 'whitted'])
    noises = (0.2, 0.1, 0.05, 0.03, 0.02, 0.01, 0.005)
    def __init__(self, program, scene, folder, integrator):
        self.words, self.folder = [program, scene, '--integrator', integrator, '--threads', '1', '-q'], folder
    def draw(self, setting, size=(WIDTH, HEIGHT)):
        samples, more = setting
        words = self.words + ['--samples', str(samples), '--imgsize', f'{size[0]},{size[1]}', '--filter', 'box', *more, '-o']
        picture = os.path.join(self.folder, 'w.exr')
        cpu(words + [picture])
        # The time is that of a PNG: loading the module that writes EXR takes longer than some of these pictures.
        return cpu(words + [os.path.join(self.folder, 'w.png')]), picture
    def settings(self, name):
        photons = (10000, 40000, 100000, 400000) if name == 'photons' and 'whitted' in self.words else (0,)
        most = MOST_SAMPLES.get(name, 256)
        for count in photons:
            also, more = (f', {count} photons', ['--photons', str(count)]) if count else ('', [])
            for samples in (n for n in (1, 4, 16, 64, 256) if n <= (16 if count else most)):
                yield f'{samples} samples{also}', (samples, ['--noise', '0', *more])
            for noise in () if 'caustics' in self.words else self.noises:
                yield f'noise {noise}{also}', (most, ['--noise', str(noise), *more])
    def truth(self, name):
        if name == 'photons' and 'whitted' in self.words:
            return self.draw((256, ['--photons', '4000000', '--noise', '0']))[1]
        return self.draw((4 * MOST_SAMPLES.get(name, 256), ['--noise', '0']))[1]

class PovRay:
    idle = (lambda text: text, ['-A'])
    def __init__(self, text, folder):
        self.text, self.folder = text, folder
    def draw(self, setting, size=(WIDTH, HEIGHT)):
        edit, options = setting
        scene, picture = os.path.join(self.folder, 'x.pov'), os.path.join(self.folder, 'p.ppm')
        open(scene, 'w').write(edit(self.text))
        return cpu(['povray', '-D', '-GA', '+WT1', f'+W{size[0]}', f'+H{size[1]}', '+FP16', 'File_Gamma=1.0', f'+I{scene}', f'+O{picture}', *options]), picture
    def settings(self, name):
        same = lambda text: text
        fixed = [(f'+AM1 +R{n}', ['+A0.0', '+AM1', f'+R{n}', '-J']) for n in (2, 3, 4, 6)]
        adaptive = [(f'+AM2 +A{a} +R{n}', [f'+A{a}', '+AM2', f'+R{n}', '-J']) for a, n in ((0.2, 2), (0.1, 3), (0.03, 4))]
        plain = [('-A', ['-A'])]
        if name == 'focal_blur':
            for n in (4, 16, 64, 256):
                yield f'blur_samples {n}', (blur(n), ['-A'])
        elif name == 'soft_shadow':
            for grid in (3, 5, 9):
                for label, options in plain + fixed[:3] + adaptive[1:2]:
                    yield f'{grid}x{grid} {label}', (lamp_grid(grid), options)
        elif name == 'photons':
            for count in (10000, 100000, 400000):
                for label, options in plain + fixed[:2] + adaptive[1:2]:
                    yield f'{count} photons {label}', (photons(count), options)
        else:
            for label, options in plain + fixed + adaptive:
                yield label, (same, options)
    def truth(self, name):
        best = ['+A0.0', '+AM1', '+R10', '-J']
        edit = {'focal_blur': blur(2048), 'soft_shadow': lamp_grid(17), 'photons': photons(4000000)}.get(name, lambda text: text)
        return self.draw((edit, ['-A'] if name == 'focal_blur' else best))[1]

def blur(samples):
    return lambda text: re.sub(r'blur_samples \d+', f'blur_samples {samples}', text)

def lamp_grid(n):
    return lambda text: re.sub(r',5,5 adaptive 2', f',{n},{n} adaptive 1', text)

def photons(count):
    """Photons for what is clear: each such object is a target of its own."""
    def edit(text):
        text = text.replace('global_settings{', f'global_settings{{photons{{count {count}}} ', 1)
        clear = {name for name, body in re.findall(r'#declare (N\d+)=(.*)', text) if 'interior{ior' in body}
        lines = []
        for line in text.splitlines():
            name = re.match(r'#declare (N\d+)=', line)
            if not name:
                # A set of clear things alone is a target whole; its parts are not.
                pass
            elif name[1] in clear or (set(re.findall(r'object\{(N\d+)', line)) and set(re.findall(r'object\{(N\d+)', line)) <= clear):
                clear.add(name[1])
                line = line[:-1] + ' photons{target reflection on refraction on collect off}}'
            lines.append(line)
        return '\n'.join(lines) + '\n'
    return edit

def measured(program, name, rounds, line):
    """Adds (seconds, error, label) of every setting; `line` keeps the least time of a label."""
    truth = pixels(program.truth(name))
    def once():
        start = min(program.draw(program.idle, (4, 3))[0] for _ in range(5))
        for label, setting in program.settings(name):
            seconds, picture = program.draw(setting)
            error = rms(pixels(picture), truth)
            known = line.get(label, (math.inf, error))
            line[label] = (min(known[0], max(1e-3, seconds - start)), error)
            yield
    return once

def front(line):
    """The settings that none beats in both, the slowest last."""
    points = sorted((seconds, error, label) for label, (seconds, error) in line.items())
    best = []
    for p in points:
        if p[1] > 0 and (not best or p[1] < best[-1][1]):
            best.append(p)
    return best

def seconds_at(points, error):
    """On the line through the two points about it, in logarithms; none beyond the line's ends but before its first point."""
    if points[0][1] <= error:
        return points[0][0]
    for (s0, e0, _), (s1, e1, _) in zip(points, points[1:]):
        if e1 <= error:
            return math.exp(math.log(s0) + math.log(s1 / s0) * math.log(error / e0) / math.log(e1 / e0))
    return None

def main():
    whittle = sys.argv[1]
    folder = sys.argv[2] if len(sys.argv) > 2 else os.path.join(os.path.dirname(os.path.abspath(__file__)), 'light')
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 2
    only = sys.argv[4].split(',') if len(sys.argv) > 4 else []
    details = []
    print('| effect | error | POV-Ray, s | by | Whittle, s | ratio |\n|---|---|---|---|---|---|')
    for name, integrator in EFFECTS:
        if only and name not in only:
            continue
        with tempfile.TemporaryDirectory() as work:
            scene, exported = os.path.join(folder, name + '.scad'), os.path.join(work, 'export.pov')
            cpu([whittle, scene, '-o', exported, '--imgsize', f'{WIDTH},{HEIGHT}', '-q'])
            ours, theirs = {}, {}
            turns = [measured(Whittle(whittle, scene, work, integrator), name, rounds, ours), measured(PovRay(open(exported).read(), work), name, rounds, theirs)]
            for _ in range(rounds):
                runs = [turn() for turn in turns]
                while runs:
                    runs = [run for run in runs if next(run, run) is not run]
        mine, other = front(ours), front(theirs)
        for k in sorted({len(other) // 3, 2 * len(other) // 3, len(other) - 1}):
            seconds, error, label = other[k]
            at = seconds_at(mine, error)
            print(f'| {name} (`{integrator}`) | {error:.5f} | {seconds:.3f} | {label} | ' + (f'{at:.3f} | {seconds / at:.2f} |' if at else '– | – |'), flush=True)
        details += [(name, 'whittle ' + integrator, p) for p in mine] + [(name, 'pov-ray', p) for p in other]
    print('\nscene,program,setting,cpu_seconds,rmse')
    for name, program, (seconds, error, label) in details:
        print(f'{name},{program},{label},{seconds:.4f},{error:.6f}')

if __name__ == '__main__':
    main()
