assert(true); assert(1,"x") cube(1); assert(condition=true,message="m"); assert(); echo("after");
