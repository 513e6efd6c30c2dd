offset() square(); offset(3) square(); offset(r=-1) square(); offset(r=1,delta=2) square(); offset(delta=-1) square(); offset(delta=1,chamfer=true) square(); offset("a") square(); offset(r=2,$fn=20) square();
projection() cube(); projection(cut=true) cube(); projection(true) cube(); projection(convexity=4) cube(); projection(cut="a") cube();
resize([1,2]) cube(); resize([1,2,3],auto=true) cube(); resize([1,2,3],auto=[true,false]) cube(); resize() cube(); resize(newsize=[5,0,0],auto=[false,true,true],convexity=3) cube(); resize([-1,0,0]) cube();
