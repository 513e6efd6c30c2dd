#include "bench/memory.h"

#include <cstdlib>
#include <fstream>
#include <string>

#include <malloc.h>

namespace whittle::bench {

std::size_t bytes_held() {
    const auto info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

bool reset_peak() {
    ::malloc_trim(0);
    std::ofstream out("/proc/self/clear_refs");
    return static_cast<bool>(out << "5" << std::flush);
}

std::size_t peak_bytes() {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("VmHWM:", 0) == 0) return std::strtoull(line.c_str() + 6, nullptr, 10) * 1024;
    return 0;
}

}  // namespace whittle::bench
