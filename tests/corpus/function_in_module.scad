module m(n) { function sq(x) = x * x + n; echo(sq(3)); } m(1); m(2);
module outer(a) { module inner(b) { echo(a, b); } inner(a + 1); } outer(1);
inner(1);
