echo(rands(0,1,3,42), rands(5,1,2,7), rands(1,1,2), rands(0,1,2,1.5), rands(0,1,2,-3), rands(0,1), rands("a",1,2), rands(0,1,-2,3), rands(0,1,2.7,3)); echo(rands(0,10,2,42)[0]==rands(0,10,2,42)[0]);
