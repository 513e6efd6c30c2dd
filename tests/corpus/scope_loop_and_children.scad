for(i=[0:1]) { j=i*2; k=j+1; echo(j,k); } module p() { x=1; children(); } p() { x=7; echo(x); } x=3; p() echo(x);
