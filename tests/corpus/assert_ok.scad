assert(true);
assert(1 == 1, "fine");
assert(condition=true, message="named");
x = assert(true) 5;
y = assert(x > 1, "big") x + 1;
echo(x, y);
assert(true) cube(1);
