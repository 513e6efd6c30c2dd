function f(n)=n==0?0:[f(n-1)]; x=f(900); echo(x==f(900)); echo(len(str(x)));
