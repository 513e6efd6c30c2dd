echo(rands(0,1));
echo(rands("a",1,2));
echo(rands(0,1,1,"x"));
