module for2() echo("f"); for2(); module echo2() {} echo2(); function each2(x)=x; echo(each2(1)); let2 = 3; echo(let2); true_ = 1; echo(true_); undef2=1; echo(undef2);
