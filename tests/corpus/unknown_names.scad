echo(nope);
echo(nofunc(1));
nomodule();
nomodule(2) cube(1);
echo(nope, nope + 1);
echo(is_undef(nope), is_undef($nope));
echo($undefd);
x = nope2;
