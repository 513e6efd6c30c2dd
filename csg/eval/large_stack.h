// large_stack.h — runs a function on a stack of its own, so that deep programs do not depend on the caller's.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace whittle {

// What parsing and evaluation count on; virtual until touched. The address sanitizer can clean only 64 MB of a stack when something is thrown.
#if defined(__SANITIZE_ADDRESS__)
#define WHITTLE_SMALL_STACK 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define WHITTLE_SMALL_STACK 1
#endif
#endif
#if defined(WHITTLE_SMALL_STACK)
inline constexpr std::size_t kLargeStackBytes = std::size_t{60} << 20;
#else
inline constexpr std::size_t kLargeStackBytes = std::size_t{1} << 30;
#endif

// Of a program's tree: what walks over it takes at most 3750 bytes of that stack a level.
inline constexpr std::uint32_t kDeepestTree = std::min<std::size_t>(100000, kLargeStackBytes / 3750);

// Calls `work` on a thread with that stack and waits. Returns false when no such thread could be made; `work` has not run then.
// Requires: `work` throws nothing.
bool run_on_large_stack(const std::function<void()>& work);

}  // namespace whittle
