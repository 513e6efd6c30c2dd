echo(1+"a", "a"+"b", true+1, undef+1, [1]+1, 1-[1], "a"*2, [1:2]*2, "a"/1, 1/"a", 1%"a", "a"%1, "a"^2, -"a", -true, -undef, -[0:1]);
echo(undef+1+2);
x = undef;
echo(x*2, [x+1]);
