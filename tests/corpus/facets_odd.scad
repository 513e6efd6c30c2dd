circle(1,$fn=2.5); circle(1,$fn=-3); circle(1,$fa=0.001); sphere(5,$fs=0.001); circle(10,$fn=0/0); circle(10,$fn=1/0); cylinder($fn=30.9);
