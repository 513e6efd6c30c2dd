echo([for (i = [0 : 1]) [for (j = [0 : 1]) i + j]], [for (i = [0 : 1]) for (j = [0 : 1]) i + j], [for (i = [0 : 1]) if (i > 0) for (j = [0 : 2]) j], [[for (i = [1 : 2]) i], [for (i = [3 : 4]) i]]);
