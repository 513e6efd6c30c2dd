a = 1;
module m() { a = 2; b = a + 1; echo(a, b); module n() { echo(a, b); a = 9; } n(); }
m(); echo(a);
