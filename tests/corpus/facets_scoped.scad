$fn=10; sphere(1); circle(1,$fn=0); $fa=30; $fs=0.5; cylinder(r=3,h=1,$fn=undef); sphere($fn=3); sphere(r=10,$fn=1); circle(r=1/1048577);
