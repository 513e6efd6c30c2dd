echo([for (i = [1 : -1 : 5]) i]);
echo([for (i = [5 : 1 : 1]) i]);
a = 5; echo([for (i = [a : 1 : 1]) i]);
