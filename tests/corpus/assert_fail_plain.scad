assert(false);
