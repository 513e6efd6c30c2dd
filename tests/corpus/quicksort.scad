function quicksort(a) = len(a) <= 1 ? a : let(p = a[floor(len(a)/2)]) concat(quicksort([for (x=a) if (x<p) x]), [for (x=a) if (x==p) x], quicksort([for (x=a) if (x>p) x]));
echo(quicksort([5,3,8,1,9,2,7]), quicksort(["pear","apple","fig"]));
