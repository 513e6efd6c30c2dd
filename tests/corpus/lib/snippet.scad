inner = 5;
module helper() cube(inner);
helper();
