module holes(l,s){if(l>0){for(x=[0:pow(3,3-l)-1],y=[0:pow(3,3-l)-1])translate([(3*x+1)*s/3,(3*y+1)*s/3,-1])cube([s/3,s/3,29]);holes(l-1,s/3);}}
difference(){cube(27);holes(3,27);translate([0,27,0])rotate([90,0,0])holes(3,27);rotate([0,90,0])mirror([1,0,0])holes(3,27);}
