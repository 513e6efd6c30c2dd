function size(n) = n < 1 ? "none" : n < 10 ? "few" : n < 100 ? "some" : "many";
for (n = [0, 5, 50, 500]) echo(n, size(n));
