if (true) { a=1; echo(a); } else echo(2); if (false) ; else if (true) echo("x"); for(i=[0:1]) { function f()=1; }
