for (r = [[0 : 0 : 0], [0 : 0 : 3], [3 : -1 : 0], [0 : -1 : 3], [0 : 1 : 0], [1 : 0.1 : 1.5], [0 : 1 / 0 : 5], [0 : 0 / 0 : 5], [0 / 0 : 5], [0 : 0 / 0], [-1 / 0 : 1], [0 : 1e-30 : 1e-29], [5 : 3], [-2 : -4], [0 : 0.3 : 1], ["a" : 3], [1 : "b"], [undef : 2], [true : 3], [1 : 2 : 3][1], [0:2][5]])
    echo(r, [for (i = r) i]);
echo([for (i = [0 : 0.1 : 1]) i]);
echo(len([0 : 3]), [0 : 3] == [0 : 1 : 3], [0 : 3] < [0 : 4], [0:3] + 1, -[0 : 3], [0 : 3][1], [0 : 3].step, [0:2:9].end);
for (i = [3 : 1]) echo("swapped", i);
for (i = [3 : -1 : 1]) echo(i);
for (i = [0 : -1 : 2]) echo("never", i);
for (i = 5) echo(i); for (i = "ab") echo(i); for (i = undef) echo("undef", i); for (i = true) echo(i); for (i = function(x) x) echo(i);
for (i = [[1, 2], [3]]) echo(i); for (i = []) echo("none"); for () echo("bare"); for (i) echo("no value", i); for (i = 1, i = [i, i + 1]) echo(i);
for (i = [0 : 20000]) echo(i);
echo([for (i = [1 : 1e7]) i]);
intersection_for(i = [3 : 1]) { echo("i", i); cube(i); }
echo([each [1 : 3], each "abc", each undef, each 5, each [[1], [2]], each each [[1, 2], [3]], each [for (i = [0 : 2]) [i, i]]]);
echo([for (i = 0, j = 10; i < j; i = i + 3, j = j - 1) [i, j]]);
