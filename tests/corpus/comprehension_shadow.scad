i = 9; echo([for (i = [0 : 1]) i], i); echo([for (i = [0 : 1], i = [5 : 6]) i]); echo([for (i = i) i]); function f(v) = [for (v = v) v]; echo(f([1, 2]));
