scale(2) cube(); scale([1,2,3]) cube(); scale([1,2]) cube(); scale("a") cube(); scale() cube(); scale([1,2,3,4]) cube(); scale([0,1,1]) cube(); scale(-1) cube();
mirror([1,0,0]) cube(); mirror([1,1,0]) cube(); mirror([1,2,3]) cube(); mirror() cube(); mirror([0,0,0]) cube(); mirror("a") cube(); mirror([1,1]) cube();
