// memory.cpp — reads /proc and the files of memory groups.
#include "modeler/cli/memory.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

#include <unistd.h>

namespace whittle {

namespace {

constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

// The number behind `name` in lines of the form "name: 12 kB" or "name 12", in the file's unit; nothing: `missing`.
std::uint64_t entry(const std::string& file, const std::string& name, std::uint64_t missing) {
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string key;
        std::uint64_t value = 0;
        if (words >> key && key == name && words >> value) return value;
    }
    return missing;
}

// The file's one number; "max" and what is not there are unknown.
std::uint64_t number_of(const std::string& file) {
    std::ifstream stream(file);
    std::uint64_t value = 0;
    return stream >> value ? value : kUnknown;
}

// Names that the two versions of memory groups give to the same things.
struct GroupFiles {
    const char *limit, *used, *inactive, *active;
};

constexpr GroupFiles kSecond{"/memory.max", "/memory.current", "inactive_file", "active_file"};
constexpr GroupFiles kFirst{"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file", "total_active_file"};

std::uint64_t left_in_group(const std::string& folder, const GroupFiles& names) {
    const std::uint64_t limit = number_of(folder + names.limit), used = number_of(folder + names.used);
    if (limit == kUnknown || used == kUnknown) return kUnknown;
    const std::string stat = folder + "/memory.stat";
    const std::uint64_t droppable = std::min(used, entry(stat, names.inactive, 0) + entry(stat, names.active, 0));
    return limit > used - droppable ? limit - (used - droppable) : 0;
}

// The least that is left in the group `path` below `mount` and in those around it. Inside a container `path` may be the host's name for it: groups that
// are not there are passed over, and the mount itself is the container's.
std::uint64_t left_in_groups(const std::string& mount, std::string path, const GroupFiles& names) {
    std::uint64_t least = kUnknown;
    while (true) {
        least = std::min(least, left_in_group(mount + (path == "/" ? "" : path), names));
        if (path.empty() || path == "/") return least;
        path.erase(path.find_last_of('/'));
    }
}

bool has_word(const std::string& list, const std::string& word) { return ("," + list + ",").find("," + word + ",") != std::string::npos; }

}  // namespace

std::uint64_t resident_bytes() {
    std::FILE* file = std::fopen("/proc/self/statm", "re");
    if (!file) return 0;
    unsigned long long whole = 0, resident = 0;
    const int read = std::fscanf(file, "%llu %llu", &whole, &resident);
    std::fclose(file);
    return read == 2 ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

std::uint64_t available_bytes(const std::string& root) {
    const std::uint64_t kilobytes = entry(root + "/proc/meminfo", "MemAvailable:", kUnknown);
    std::uint64_t least = kilobytes == kUnknown ? kUnknown : kilobytes * 1024;
    std::ifstream groups(root + "/proc/self/cgroup");
    for (std::string line; std::getline(groups, line);) {  // number:controllers:path
        const std::size_t first = line.find(':'), second = first == std::string::npos ? first : line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
        if (path.empty() || path[0] != '/') continue;
        if (controllers.empty()) least = std::min(least, left_in_groups(root + "/sys/fs/cgroup", path, kSecond));
        else if (has_word(controllers, "memory")) least = std::min(least, left_in_groups(root + "/sys/fs/cgroup/memory", path, kFirst));
    }
    return least;
}

std::uint64_t memory_left(std::uint64_t resident, std::uint64_t available) {
    if (available == kUnknown) return kUnknown;
    const auto spare = static_cast<std::uint64_t>(kSpareShare * (static_cast<double>(resident) + static_cast<double>(available)));
    return available > spare ? available - spare : 0;
}

int wait_for_memory_ms(std::uint64_t left) { return static_cast<int>(std::clamp<std::uint64_t>(left / 8'000'000, 20, 500)); }

}  // namespace whittle
