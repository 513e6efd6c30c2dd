p = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]; f = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
polyhedron(p, f); polyhedron(points = p, faces = f, convexity = 3); polyhedron(points = p, triangles = f); polyhedron(p, [[0, 1, 2, 3]]); polyhedron(); polyhedron([], []);
