t = [[1,[2,[3,[4]]]],"x",[[]]];
echo(t, t[0][1][1][1][0], len(t), t[2][0], t[0][1].x);
function flat(l) = [for (a=l) for (b=a) b];
echo(flat([[1,2],[3],[]]));
function rev(l) = [for (i=[len(l)-1:-1:0]) l[i]];
echo(rev([1,2,3]));
function sum(v, i=0) = i < len(v) ? v[i] + sum(v, i+1) : 0;
echo(sum([for (i=[1:100]) i]));
