// Points, rotations, a curve and its frames: what a library of parts spends its time with.
function rot(a) = [[cos(a), -sin(a), 0], [sin(a), cos(a), 0], [0, 0, 1]];
function unit(v) = v / norm(v);
function bezier(p, t) = len(p) == 1 ? p[0] : bezier([for (i = [0 : len(p) - 2]) (1 - t) * p[i] + t * p[i + 1]], t);
control = [[0, 0, 0], [10, 0, 5], [10, 10, 10], [0, 10, 15], [5, 5, 30]];
curve = [for (i = [0 : 8000]) bezier(control, i / 8000)];
tangents = [for (i = [0 : len(curve) - 2]) unit(curve[i + 1] - curve[i])];
normals = [for (t = tangents) unit(cross(t, [0, 0, 1]))];
turned = [for (i = [0 : 80000]) rot(i) * [1, 2, 3] + [i, 0, 0]];
mixed = [for (i = [0 : 40000]) (rot(i) * rot(2 * i))[0] * [1, 2, 3]];
length = [for (i = 0, s = 0; i < len(tangents); s = s + norm(curve[i + 1] - curve[i]), i = i + 1) s];
echo(len(turned), len(normals), length[len(length) - 1], turned[777], mixed[100]);
