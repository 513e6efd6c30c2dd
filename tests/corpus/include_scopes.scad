include <lib/values.scad>
echo(size, size_twice());
size = 9;
marker();
