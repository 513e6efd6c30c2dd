difference(){intersection(){cube(20,center=true);sphere(13.5,$fn=64);}for(a=[[0,0,0],[90,0,0],[0,90,0]])rotate(a)cylinder(r=6,h=30,center=true,$fn=64);}
