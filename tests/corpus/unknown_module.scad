foo(); foo() cube(); foo(1, a = 2) { cube(); }
module bar() { baz(); } bar();
