// What a loop goes through.
for (c = "añ") echo(c);
for (x = 5) echo(x);
for (x = undef) echo("never");
for (x = true) echo(x);
for (x = []) echo("never");
for (x = [[1, 2], [3]]) echo(x);
for (f = function(x) x) echo(f);
for (a = [0:1], b = [a:1]) echo(a, b);
for (x = [0:-1]) echo("swapped", x);
for (x = [3:-1:1]) echo(x);
for (x = [0:0.1:0.3]) echo(x);
for (x = [1:0:5]) echo("never");
for ($s = [1, 2]) echo($s);
