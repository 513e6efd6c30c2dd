intersection_for(i=[0:2]) rotate([0,0,i*30]) cube([5,1,1],center=true);
intersection_for(i=[0:1],j=[0:1]) cube(1+i+j);
intersection() { for (i=[1:3]) cube(i); sphere(2); }
