difference(){translate([-1,-1,0])cube([102,102,5]);for(x=[0:9],y=[0:9])translate([5+10*x,5+10*y,-1])cylinder(r=3,h=7,$fn=64);}
