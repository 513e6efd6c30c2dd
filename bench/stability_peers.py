#!/usr/bin/env python3
"""stability_peers.py CASES_DIR CSV — POV-Ray and OpenSCAD on the cases that `whittle-bench stability --cases CASES_DIR` wrote; rows are appended to CSV.

POV-Ray answers each ray with its trace() function (first hit); a hit that is missing, too many, or off by more than a quarter of the thinnest wall is
wrong. OpenSCAD makes a mesh of the solid, where it is of boxes alone: `wrong` is 1 if the mesh's volume is off by more than a thousandth of the wall's.
"""
import glob, math, os, struct, subprocess, sys, tempfile

def read(path):
    lines = open(path).read().split('\n')
    size, thinnest = map(float, lines[2].split())
    words = lines[4].split()
    nest = [(words[i], float(words[i + 1])) for i in range(0, len(words), 2)]
    return lines[0], float(lines[1]), size, thinnest, list(map(float, lines[3].split())), nest, [list(map(float, l.split())) for l in lines[5:] if l]

def pov_text(m, nest, rays_file, answers_file):
    text = ''
    for kind, half in reversed(nest):
        one = f'box {{ <-{half!r},-{half!r},-{half!r}>, <{half!r},{half!r},{half!r}> }}' if kind == 'box' else f'sphere {{ <0,0,0>, {half!r} }}'
        text = f'difference {{ {one} {text} }}' if text else one
    columns = ', '.join(repr(m[4 * row + column]) for column in range(4) for row in range(3))
    return f'''#version 3.7;
#declare Nest = object {{ {text} matrix <{columns}> }}
#fopen Rays "{rays_file}" read
#fopen Answers "{answers_file}" write
#declare N = <0,0,0>;
#while (defined(Rays))
  #read (Rays, A, B, C, D, E, F)
  #declare O = <A,B,C>;
  #declare P = trace(Nest, O, <D,E,F>, N);
  #if (vlength(N) = 0)
    #write (Answers, "-1\\n")
  #else
    #write (Answers, str(vlength(P - O) / vlength(<D,E,F>), 0, 17), "\\n")
  #end
#end
#fclose Answers
camera {{ location <0,0,-5> look_at 0 }}
'''

def ask_povray(case, folder):
    axis, value, size, thinnest, m, nest, rays = case
    rays_file, answers_file = os.path.join(folder, 'rays.txt'), os.path.join(folder, 'answers.txt')
    open(rays_file, 'w').write(',\n'.join(', '.join(repr(x) for x in r[:6]) for r in rays))
    scene = os.path.join(folder, 'scene.pov')
    open(scene, 'w').write(pov_text(m, nest, rays_file, answers_file))
    if os.path.exists(answers_file):
        os.remove(answers_file)
    subprocess.run(['povray', f'+I{scene}', '-D', '+W1', '+H1', f'+O{folder}/out.png', '-GA', '+L' + folder], capture_output=True, cwd=folder)
    if not os.path.exists(answers_file):
        return None
    got = [float(x) for x in open(answers_file).read().split()]
    if len(got) != len(rays):
        return None
    wrong, errors = 0, []
    for r, t in zip(rays, got):
        unit = math.sqrt(sum(x * x for x in r[3:6])) / size
        if (t < 0) != (r[6] < 0):
            wrong += 1
        elif t >= 0:
            errors.append(abs(t - r[6]) * unit)
            wrong += errors[-1] > 0.25 * thinnest
    errors.sort()
    return wrong / len(rays), errors[len(errors) // 2] if errors else 0, errors[-1] if errors else 0

def stl_volume(path):
    volume, points = 0.0, []
    for line in open(path):
        words = line.split()
        if words and words[0] == 'vertex':
            points.append([float(x) for x in words[1:]])
            if len(points) == 3:
                a, b, c = points
                volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
                points = []
    return volume

def ask_openscad(case, folder):
    axis, value, size, thinnest, m, nest, rays = case
    if any(kind == 'ball' for kind, _ in nest):
        return None
    text = ''
    for kind, half in reversed(nest):
        one = f'cube({2 * half!r}, center = true);'
        text = f'difference() {{ {one} {text} }}' if text else one
    rows = ', '.join('[' + ', '.join(repr(x) for x in m[4 * i:4 * i + 4]) + ']' for i in range(3))
    scene, mesh = os.path.join(folder, 'scene.scad'), os.path.join(folder, 'mesh.stl')
    open(scene, 'w').write(f'multmatrix([{rows}, [0, 0, 0, 1]]) {text}\n')
    if os.path.exists(mesh):
        os.remove(mesh)
    subprocess.run(['openscad', '-o', mesh, '--export-format', 'asciistl', scene], capture_output=True)
    det = (m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]))
    truth = abs(det) * sum((2 * half) ** 3 * (-1) ** i for i, (_, half) in enumerate(nest))
    off = abs(stl_volume(mesh) - truth) / truth if os.path.exists(mesh) else 1.0
    return float(off > 1e-3), off, off

def main():
    folder, csv = sys.argv[1:3]
    with open(csv, 'a') as out, tempfile.TemporaryDirectory() as work:
        for path in sorted(glob.glob(os.path.join(folder, 'case_*.txt'))):
            case = read(path)
            for program, ask in (('povray', ask_povray), ('openscad', ask_openscad)):
                answer = ask(case, work)
                if answer:
                    print(case[0], case[1], program, 'wrong %.5f error %.1e worst %.1e' % answer, flush=True)
                    out.write(f'{case[0]},{case[1]},{program},{len(case[6])},0,{answer[0]},{answer[1]},{answer[2]},,,,\n')

if __name__ == '__main__':
    main()
