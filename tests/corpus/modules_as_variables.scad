// Three namespaces: a variable, a function and a module of one name.
same = 1;
function same(x) = x + same;
module same(x) { echo("module", x, same, same(x)); }
same(2);
echo(same, same(10));
let (same = function(x) x * 100) echo(same(3));
let (same = 7) echo(same(3));
