echo([for (i = [0 : 2]) let (j = i * i) j], [let (a = 1) for (i = [0 : 1]) a + i], [for (i = [1 : 2]) let (a = i, b = a + 1) if (b > 2) [a, b]], [let (x = 5) x]);
