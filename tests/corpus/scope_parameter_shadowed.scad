a=1; module m(b=a) { a=2; echo(a,b); { a=3; } echo(a); } m(); m(b=5); echo(a);
