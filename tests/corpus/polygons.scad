polygon([[0,0],[1,0],[0,1]]);
polygon(points=[[0,0],[10,0],[0,10],[2,2],[4,2],[2,4]], paths=[[0,1,2],[3,4,5]]);
polygon(points=[[0,0],[1,0],[1,1]], convexity=4);
polyhedron(points=[[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces=[[0,1,2],[0,3,1],[0,2,3],[1,3,2]]);
polyhedron(points=[[0,0,0],[1,0,0],[0,1,0],[0,0,1]], triangles=[[0,1,2],[0,3,1],[0,2,3],[1,3,2]], convexity=2);
polygon();
polyhedron();
