echo(1<"a", undef<1, true<1, [1]<["a"], [1,[2,3]]<[1,[2,"x"]], undef<undef);
f = function(x) x;
echo(f<f, f==f, f!=f, "a">[1]);
