echo(rands());
echo(rands(1, 2));
echo(rands("a", 1, 1));
echo(rands(0, 1, 1, "s"));
echo(rands(0, 1/0, 1, 1));
echo(rands(0, 1, 1/0, 1));
echo(rands(-1/0, 0, 1, 1));
echo(rands(0, 0/0, 1, 1));
