// Quicksort and merges of random numbers, binary search, unique values.
function quicksort(v) = len(v) < 2 ? v : let (p = v[floor(len(v) / 2)])
    concat(quicksort([for (x = v) if (x < p) x]), [for (x = v) if (x == p) x], quicksort([for (x = v) if (x > p) x]));
function find(v, x, a, b) = a >= b ? a : let (m = floor((a + b) / 2)) v[m] < x ? find(v, x, m + 1, b) : find(v, x, a, m);
function insert(v, x) = [for (y = v) if (y < x) y, x, for (y = v) if (y >= x) y];
function insertion_sort(v, i = 0, done = []) = i == len(v) ? done : insertion_sort(v, i + 1, insert(done, v[i]));
random = rands(0, 1000, 30000, 1);
sorted = quicksort(random);
found = [for (i = [0 : 30000]) find(sorted, i / 30, 0, len(sorted))];
inserted = insertion_sort([for (i = [0 : 1500]) random[i]]);
echo(sorted[0], sorted[15000], found[15000], inserted[250], min(random), max(random));
