echo(abs(-1), sign(-2), sign(0), sign(3), sign(0/0), round(2.5), round(-2.5), ceil(1.1), floor(-1.1), sqrt(2), exp(1), ln(10), log(1000), log(2,8), pow(2,10), pow(2,0.5), ln(0), log(0), sqrt(-1));
echo(min(3,1,2), max(3,1,2), min([3,1,2]), max([3,1,2]), min(1), max([5]), max("a" < "b" ? 1 : 2, 0), max(1,0/0), max(0/0,1), min([1,"a"]), max(["b","c"]));
echo(norm([3,4]), norm([1,2,3]), norm([]), cross([1,0,0],[0,1,0]), cross([1,2],[3,4]), 10 % 4);
