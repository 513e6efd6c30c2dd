r=[1:2:9]; echo(r, r[0], r[1], r[2], r[3], r.begin, r.step, r.end, r.x, [0:5], len(r));
