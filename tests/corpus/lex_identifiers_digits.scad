2d = 5; 3 = 4; a1_b = 1; _x = 2; $s = 3; echo(2d, a1_b, _x, $s); echo(1e3, 7e);
function 9f(x) = x; echo(9f(3));
