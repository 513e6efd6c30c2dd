// int128.h — the compiler's 128-bit integer under one name: determinants of grid coordinates fit in it.
#pragma once

#include "modeler/arrange/grid_mesh.h"
