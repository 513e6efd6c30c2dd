// crossing_kernel.h — the crossing kernels for a single ray, in namespace `single`.
#pragma once

#ifdef HWY_NAMESPACE
#error "Include this before Highway: the kernels are compiled once for single rays"
#endif
#include "tracer/engine/crossing_kernel.inc"
#include "tracer/engine/quadric_kernel.inc"
