// memory.h — how much memory this run holds and how much it could still get, so that one that grows without end says so before the system kills it.
//
// What could be had is asked of the kernel at every look, since other programs take and give memory too: MemAvailable of /proc/meminfo (swap does not
// count: a run that swaps is as good as stopped), and for each memory group that holds the process (cgroup v2 or v1), its limit less what is used, where
// pages of files that can be dropped are not counted.
// Source: Linux, Documentation/filesystems/proc.rst (MemAvailable); admin-guide/cgroup-v2.rst; admin-guide/cgroup-v1/memory.rst.
#pragma once

#include <cstdint>
#include <string>

namespace whittle {

enum class MemoryLimit {
    kSystem,  // what the system and the process's memory groups can give, less a spare part (memory_left())
    kBytes,   // so many resident bytes
    kNone,
};

// Of all that a run holds and could still get, the part that it leaves.
inline constexpr double kSpareShare = 0.1;

// Bytes of memory that this process holds (resident); 0 where /proc does not say.
std::uint64_t resident_bytes();

// Bytes that this process could still get without swapping: the least of what the system and the process's memory groups have left; 2^64-1 where nothing
// is known. `root` stands before /proc and /sys (for tests).
std::uint64_t available_bytes(const std::string& root = "");

// Bytes that a run which holds `resident` and could get `available` more may still take before it must end; 0: it must. A run that holds less than nine
// times what is left goes on, whatever others hold.
std::uint64_t memory_left(std::uint64_t resident, std::uint64_t available);

// Milliseconds until the next look: what taking `left` bytes would last at 8 GB/s, from 20 to 500.
int wait_for_memory_ms(std::uint64_t left);

}  // namespace whittle
