// Three thousand calls that are not in tail position are no endless recursion.
function sum(n) = n == 0 ? 0 : n + sum(n - 1);
echo(sum(3000));
function length(v, i = 0) = i == len(v) ? 0 : 1 + length(v, i + 1);
echo(length([for (i = [1:2000]) i]));
module nested(n) { if (n > 0) translate([0, 0, 1]) nested(n - 1); else cube(1); }
nested(50);
