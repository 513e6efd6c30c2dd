// Precedence and association.
echo(2 ^ 3 ^ 2, -2 ^ 2, 2 ^ -1, 2 * 3 % 4, 10 - 3 - 2, 16 / 4 / 2, !true == false, - - 3, !!3);
echo(1 < 2 == true, 1 + 2 < 4 && 3 > 2 || false, true ? 1 : false ? 2 : 3, false ? 1 : true ? 2 : 3);
echo([1, 2, 3][1] ^ 2, -[1, 2][0], [[1, 2], [3, 4]][1][0], [1, 2, 3].y * 2, "abc"[1], (function(x) x + 1)(2) * 3);
echo(1 ? "t" : "f", 0 ? "t" : "f", "" ? "t" : "f", [] ? "t" : "f", [0] ? "t" : "f", undef ? "t" : "f", (0 / 0) ? "t" : "f", [1:0] ? "t" : "f");
echo(let (a = 1, b = a + 1) a + b, assert(true) 5, [let (a = 2) a * 2]);
