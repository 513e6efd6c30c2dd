function join(v, sep=",", i=0) = i >= len(v) ? "" : i == len(v)-1 ? str(v[i]) : str(v[i], sep, join(v, sep, i+1));
echo(join([1,2,3]), join(["a","b"], " - "), join([]));
function upper(s) = chr([for (c=s) let(o=ord(c)) o>=97 && o<=122 ? o-32 : o]);
echo(upper("hello World"));
