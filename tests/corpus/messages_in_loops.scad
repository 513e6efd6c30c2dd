for(i=[0:9]) echo(nope); foo(); foo(); x=bar(1); cube(nope2);
