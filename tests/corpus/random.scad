echo(rands(0,1,3,42), rands(0,1,2), rands(5,10,2,7), rands(10,5,2,7), rands(3,3,2,1), rands(0,1,0,1), rands(0,1,2.7,5), rands(0,1,-2,1));
echo(rands(0,1,2,-1), rands(0,1,1,1.5), rands(0,1,1,4294967296), rands(0,1,1,0), rands(-1,1,2,1e30));
