echo([for (i=0; i<3; i=i+1) i], [for (i=0,j=10; i<3; i=i+1,j=i) [i,j]], [for (i=0,s=0; i<4; s=s+i,i=i+1) s]);
echo([for (i=0; i<0; i=i+1) i], [for (a=1,b=1; a<50; t=a+b,a=b,b=t) a]);
function fibs(n) = [for (i=0,a=0,b=1; i<n; i=i+1,c=a+b,a=b,b=c) a];
echo(fibs(8));
