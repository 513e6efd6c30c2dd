assign(a=1, b=2) echo(a, b);
module m() child(0);
m() cube(1);
child(1);
r = [9:1];
polyhedron(points=[[0,0,0]], triangles=[[0,0,0]]);
