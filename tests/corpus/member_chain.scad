v = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]; echo(v.x.y, v.z[1], v[1].z, v.x, [1, 2].z, 5 .x, "ab".x, undef.x, v.foo);
r = [1 : 2 : 9]; echo(r.begin, r.step, r.end, r[0], r[1], r[2], r[3], r.x);
