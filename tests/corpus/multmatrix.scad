multmatrix([[1,2,3,4],[5,6,7,8],[9,10,11,12],[0,0,0,1]]) cube();
multmatrix([[1,2,3,4],[1,2],[1]]) cube(); multmatrix() cube(); multmatrix(5) cube(); multmatrix([[1,2],"a"]) cube();
multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,2]]) cube();
multmatrix(m=[[cos(30),-sin(30),0,1],[sin(30),cos(30),0,2],[0,0,1,3]]) cube();
