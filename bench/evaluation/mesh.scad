// Points and faces of a gear and of a twisted tube, as generated models make them.
function involute(r, a) = [r * (cos(a) + a * PI / 180 * sin(a)), r * (sin(a) - a * PI / 180 * cos(a))];
teeth = 600;
outline = [for (k = [0 : teeth - 1]) let (s = 360 / teeth) each [for (i = [0 : 10]) let (p = involute(50, i * 2)) [p.x * cos(k * s) - p.y * sin(k * s), p.x * sin(k * s) + p.y * cos(k * s)]]];
rings = 600;
sides = 60;
points = [for (i = [0 : rings - 1]) for (j = [0 : sides - 1]) let (a = 360 * j / sides + i, r = 10 + 2 * sin(i * 5)) [r * cos(a), r * sin(a), i]];
faces = concat([[for (j = [0 : sides - 1]) j]],
    [for (i = [0 : rings - 2], j = [0 : sides - 1]) let (k = (j + 1) % sides) [i * sides + j, (i + 1) * sides + j, (i + 1) * sides + k, i * sides + k]],
    [[for (j = [sides - 1 : -1 : 0]) (rings - 1) * sides + j]]);
polygon(outline);
polyhedron(points, faces);
echo(len(outline), len(points), len(faces));
