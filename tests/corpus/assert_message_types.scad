assert(false, undef);
