nan=0/0; echo(nan==nan, nan!=nan, [nan]==[nan], nan<1, nan?1:2, -nan, 1/0, -1/0, 0/0, -0, [-0], 1/-0);
