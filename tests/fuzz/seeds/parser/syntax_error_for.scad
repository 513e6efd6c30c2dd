echo([for i = [0:1] i]);
