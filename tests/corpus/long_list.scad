v = [for (i = [0 : 999]) i]; echo(v[999], len(v), v[500] * 2); echo([for (i = [0 : 100 : 999]) v[i]]);
