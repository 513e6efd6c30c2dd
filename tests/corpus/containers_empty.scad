intersection(){ if(false) cube(1); sphere(1);} difference(){ for(i=[]) cube(1); cube(2);} difference(){union(){} cube(2);} module e(){} difference(){e(); cube(1);} union(){}
