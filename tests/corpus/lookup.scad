t = [[-200,5],[-50,20],[-20,18],[80,25],[150,2]];
echo(lookup(-300,t), lookup(-200,t), lookup(-100,t), lookup(0,t), lookup(80,t), lookup(100,t), lookup(500,t));
echo(lookup(1.5,[[2,20],[1,10]]), lookup(1,[]), lookup(1,5), lookup(1,[["a",1]]), lookup(1,[[0,0],[2]]), lookup(5,[[1,1],[1,2]]), lookup(0/0,t));
