module m(a) { echo(a); echo(str(a),b=a); } m([1,"x",[true,undef]]); x = echo("in") 5; echo(x); echo(echo(1) 2); y = [for(i=[0:1]) echo(i) i]; echo(y); echo("a","b",c="d"); echo(c=undef);
