for(a=[0:15:360]) echo(a, sin(a), cos(a), tan(a)); echo(sin(1e20), tan(90), tan(-90), tan(270), sin(720000000030), asin(0.5), acos(0.5), atan(1), atan2(1,-1), atan2(0,0), asin(2), atan(1e99));
