// Functions as values: map, filter, fold, composition.
map = function(f, v) [for (x = v) f(x)];
filter = function(f, v) [for (x = v) if (f(x)) x];
function fold(f, v, start, i = 0) = i == len(v) ? start : fold(f, v, f(start, v[i]), i + 1);
compose = function(outer, inner) function(x) outer(inner(x));
twice = function(x) 2 * x;
next = function(x) x + 1;
numbers = [for (i = [0 : 60000]) i];
odd = filter(function(x) x % 2 == 1, numbers);
made = map(compose(twice, compose(next, twice)), numbers);
total = fold(function(a, b) a + b, made, 0);
echo(len(odd), total);
