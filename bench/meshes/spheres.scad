r=rands(0,100,600,42);union(){for(i=[0:199])translate([r[3*i],r[3*i+1],r[3*i+2]])sphere(10,$fn=32);}
