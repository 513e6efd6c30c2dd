echo(len([for(i=0;i<999999;i=i+1) 1])); echo(len([for(i=0;i<1000001;i=i+1) 1])); echo("after");
