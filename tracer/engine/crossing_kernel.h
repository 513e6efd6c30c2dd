// crossing_kernel.h — the crossing kernel for a single ray, in namespace `single`.
#pragma once

#ifdef HWY_NAMESPACE
#error "Include this before Highway: the kernel is compiled once for single rays"
#endif
#include "tracer/engine/crossing_kernel.inc"
