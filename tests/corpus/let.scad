echo(let(a=1, b=a+1) a+b, let(a=5) let(b=a) b, let() 3);
a = 1;
echo(let(a=a+1) a, a);
echo(let(a=1, a=2) a);
let(x=1, y=x*2) { echo(x, y); cube([x,y,1]); }
let(x=1, x=2) echo(x);
