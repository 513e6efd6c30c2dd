echo([0 : "a"], ["a" : 1], [0 : "x" : 5], [undef : 1], [0 : true], [[1] : 2]);
echo([0:1] + 1);
echo(len([0 : 2]));
echo(concat([0 : 2], 3));
