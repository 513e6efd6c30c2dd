function f(n,s=0) = n==0 ? s : f(n-1,s+n); echo(f(999990)); function g(n) = n==0 ? 0 : 1+g(n-1); echo(g(2500));
