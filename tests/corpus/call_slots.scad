module m(a,b=a+1) echo(a,b); m(1); m(b=9,4); m(1,a=2); function f(a,b) = [a,b]; echo(f(a=1,5), f(1,2,3), f(zz=4), f(), f(b=1,a=2)); module n() echo(zz); n(zz=3);
