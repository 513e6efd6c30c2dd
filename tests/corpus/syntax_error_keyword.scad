x = module;
