module a() b();
module b() assert(1 > 2 ? true : false);
a();
