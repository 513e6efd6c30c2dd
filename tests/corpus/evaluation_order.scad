function f(b, a, c=echo("dc") 3, d=echo("dd") 4) = [a, b, c];
x = f(echo("arg1") 1, c=echo("argc") 2, a=echo("arga") 9);
echo(x);
module n(alpha,beta,gamma,delta,x,y,z) {}
n(x=echo("x") 1,alpha=echo("alpha") 1,z=echo("z")1,y=echo("y") 1,delta=echo("delta") 1,gamma=echo("gamma") 1,beta=echo("beta") 1);
cube(center=echo("center") true, size=echo("size") 3);
