echo("before");
x = 3;
assert(x > 5 && x < 7, str("x is ", x));
echo("after");
