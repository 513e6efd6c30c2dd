// A tiny calculator and a turtle, written in the language itself: strings, recursion, tail calls, tables, let chains.
function is_digit(c) = c >= "0" && c <= "9";
function substr(s, from, to, acc = "") = from >= to ? acc : substr(s, from + 1, to, str(acc, s[from]));
function join(v, sep = ", ", i = 0, acc = "") = i == len(v) ? acc : join(v, sep, i + 1, str(acc, i == 0 ? "" : sep, v[i]));
function split(s, sep, i = 0, from = 0, acc = []) = i == len(s) ? concat(acc, [substr(s, from, i)]) : s[i] == sep ? split(s, sep, i + 1, i + 1, concat(acc, [substr(s, from, i)])) : split(s, sep, i + 1, from, acc);
function number_at(s, i, v = 0) = i < len(s) && is_digit(s[i]) ? number_at(s, i + 1, v * 10 + ord(s[i]) - 48) : [v, i];
function factor(s, i) = s[i] == "(" ? let (e = expr(s, i + 1)) assert(s[e[1]] == ")", str("missing ) at ", e[1])) [e[0], e[1] + 1] : s[i] == "-" ? let (f = factor(s, i + 1)) [-f[0], f[1]] : number_at(s, i);
function term_rest(s, l) = s[l[1]] == "*" ? let (r = factor(s, l[1] + 1)) term_rest(s, [l[0] * r[0], r[1]]) : s[l[1]] == "/" ? let (r = factor(s, l[1] + 1)) term_rest(s, [l[0] / r[0], r[1]]) : l;
function term(s, i) = term_rest(s, factor(s, i));
function expr_rest(s, l) = s[l[1]] == "+" ? let (r = term(s, l[1] + 1)) expr_rest(s, [l[0] + r[0], r[1]]) : s[l[1]] == "-" ? let (r = term(s, l[1] + 1)) expr_rest(s, [l[0] - r[0], r[1]]) : l;
function expr(s, i = 0) = expr_rest(s, term(s, i));
function calc(s) = expr(s)[0];
for (s = ["1+2*3", "(1+2)*3", "-4*(2-7)/3", "100/8/5", "2*(3+4)*5-6", ""]) echo(s, calc(s));
function turtle(s, i = 0, p = [0, 0], a = 0, acc = [[0, 0]]) = i >= len(s) ? acc
    : s[i] == "F" ? let (q = p + 5 * [cos(a), sin(a)]) turtle(s, i + 1, q, a, concat(acc, [q]))
    : turtle(s, i + 1, p, a + (s[i] == "+" ? 60 : s[i] == "-" ? -60 : 0), acc);
function koch(n) = n == 0 ? "F" : let (k = koch(n - 1)) str(k, "+", k, "--", k, "+", k);
path = turtle(str(koch(2), "--", koch(2), "--", koch(2)));
echo(len(koch(3)), len(path), path[len(path) - 1], norm(path[len(path) - 1]) < 1e-9);
linear_extrude(3) polygon([for (i = [0 : len(path) - 2]) path[i]]);
config = [["width", 30], ["holes", [3, 5, 8]], ["name", "plate"], ["nested", [["a", 1], ["b", [1, 2]]]]];
function get(c, k, default = undef) = let (i = search([k], c, 1, 0)) len(i) == 0 || is_list(i[0]) ? default : c[i[0]][1];
echo(get(config, "width"), get(config, "none", "default"), get(get(config, "nested"), "b"), join(get(config, "holes"), "; "), split("a,bc,,d", ","));
translate([0, 40, 0]) difference() { cube([get(config, "width"), 20, 3]); for (i = [0 : len(get(config, "holes")) - 1]) translate([6 + i * 9, 10, -1]) cylinder(d = get(config, "holes")[i], h = 5, $fn = 16); }
function primes(n) = [for (i = 2, s = [for (k = [0 : n]) true]; i <= n; s = s[i] ? [for (k = [0 : n]) k > i && k % i == 0 ? false : s[k]] : s, i = i + 1) if (s[i]) i];
echo(primes(30), [for (a = [1 : 20], b = [a : 20]) let (c = sqrt(a * a + b * b)) if (c == floor(c) && c <= 20) [a, b, c]]);
function hanoi(n, a = "A", b = "B", c = "C") = n == 0 ? [] : concat(hanoi(n - 1, a, c, b), [str(a, c)], hanoi(n - 1, b, a, c));
echo(len(hanoi(8)), hanoi(3));
function gcd(a, b) = b == 0 ? a : gcd(b, a % b);
echo(gcd(1071, 462), [for (i = [0.1, -7, 1e10, 1 / 3]) str(i)], join([for (c = "straße") ord(c)], " "));
translate([60, 0, 0]) for (i = [0 : 3]) let (r = 10 - 2 * i) translate([0, 0, i * 3]) cylinder(r = r, h = 3, $fn = 3 + i);
