x = 1; function f(x) = let (x = x + 1) [for (x = [x : x + 1]) x]; echo(f(5), x); module m(x) { let (x = x * 2) { for (x = [x]) echo(x); } } m(3);
