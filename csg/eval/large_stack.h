// large_stack.h — runs a function on a stack of its own, so that deep programs do not depend on the caller's.
#pragma once

#include <cstddef>
#include <functional>

namespace whittle {

// What parsing and evaluation count on; virtual until touched.
inline constexpr std::size_t kLargeStackBytes = std::size_t{1} << 30;

// Calls `work` on a thread with that stack and waits. Returns false when no such thread could be made; `work` has not run then.
// Requires: `work` throws nothing.
bool run_on_large_stack(const std::function<void()>& work);

}  // namespace whittle
