// A function literal that calls itself last, through the variable that holds it, is iterated.
sum = function(n, s=0) n == 0 ? s : sum(n - 1, s + n);
echo(sum(200000));
module m() {
    count = function(n) let (k = n - 1) k > 0 ? assert(true) count(k) : str("end ", k);
    echo(count(150000));
}
m();
