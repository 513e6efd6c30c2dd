echo($fn, $fa, $fs, $t, $preview, $vpr, $vpt, $vpd, $vpf, $children, $parent_modules);
