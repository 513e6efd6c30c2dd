polygon([[0,0],[1,0],"a"]);
polyhedron(points=[[0,0,0],[1,1]], faces=[[0,"a"]]);
