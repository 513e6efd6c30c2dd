// int128.h — the compiler's 128-bit integer under one name: determinants of grid coordinates fit in it.
#pragma once

namespace whittle {

__extension__ typedef __int128 Int128;

}  // namespace whittle
