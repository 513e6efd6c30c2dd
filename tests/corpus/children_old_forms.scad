module m() { child(1); child(); } m() { cube(1); sphere(2); } assign(a=1,b=2) echo(a,b); cube(1) sphere(1);
