echo(function(x) x, function(x,y=2) x+y*2, function() -x, function(a) a?1:[1,2], function(a) let(b=a) b);
echo(function(a) [for(i=[0:a]) if(i>1) i else each [i,i]], function(a) f(a, x=3)[1].y, function(a) !a && true || "s\n");
echo(function(a) 2^a, function(a) [0:a], function(a) [0:2:a], function(x) function(y) x+y, function(a) a.x[1](2));
echo(function(a) assert(a>0,"m") echo("x") a, function(a) [for(i=0;i<a;i=i+1) i], function(a) [for(i=[1:2]) let(b=i) if(b>1) b]);
