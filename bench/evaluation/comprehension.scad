// Lists of lists: grids, filters, sums, a sieve.
n = 600;
grid = [for (i = [0 : n - 1]) [for (j = [0 : n - 1]) i * j % 7]];
flat = [for (row = grid) each row];
even = [for (x = flat) if (x % 2 == 0) x];
function total(list) = [for (i = 0, s = 0; i <= len(list); s = s + (i < len(list) ? list[i] : 0), i = i + 1) s][len(list)];
primes = [for (i = [2 : 5000]) if (len([for (k = [2 : sqrt(i)]) if (i % k == 0) k]) == 0) i];
pairs = [for (i = [0 : 400], j = [0 : 400]) if (i < j) let (d = j - i) [i, j, d * d]];
echo(len(flat), len(even), total(flat), len(primes), len(pairs));
