for(i=[0:9998]) if(i==9998) echo(i); for(i=[0:10000]) echo(i); echo(chr([65:70]), chr([0:20000]));
