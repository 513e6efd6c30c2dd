a = [for (i=[0:2]) function() i];
echo(a[0](), a[1](), a[2]());
