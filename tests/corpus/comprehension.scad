echo([for (i=[0:3]) i*i], [for (i=[0:2], j=[0:i]) [i,j]], [for (i=[1,2]) for (j=[3,4]) i*j]);
echo([for (i=[0:5]) if (i%2==0) i], [for (i=[0:3]) if (i>1) i else -i], [if (true) 1], [if (false) 1], [if (false) 1 else 2]);
echo([for (i=[0:2]) let(k=i*2) if (k>0) k], [for (i=[0:1]) each [i,i]], [each [1,2], each [3:5], each "ab", each 5, each undef]);
echo([for (c="abc") c], [for (x=5) x], [for (x=undef) x], [for (x=[]) x], [1, for (i=[2,3]) i, 4]);
echo([for (i=[[1,2],[3]]) each i], [each each [[1,2],[3]]], [for (i=[0:1]) [for (j=[0:1]) i+j]]);
echo([let(a=3) each [a,a]], [for (i=[0:1]) (if (i>0) 9)]);
