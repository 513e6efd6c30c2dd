a = b; b = 1; echo(a); function f() = c; c = 4; echo(f()); d = f(); echo(d); e = g2(); function g2() = h2; h2 = 5; echo(e);
