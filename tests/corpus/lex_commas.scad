echo([1,2,], [1,,2], [1,,2,]); function f(a,b,) = a + b; echo(f(1,,2));
module m(a,,b) echo(a, b);
m(1,,2); echo(,1); echo([,]);
