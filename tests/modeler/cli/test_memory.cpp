// test_memory.cpp — how much memory a run may take: what the kernel's files say, and that a run ends by itself before it is killed.
#include <catch2/catch.hpp>

#include <filesystem>
#include <limits>

#include "modeler/cli/memory.h"
#include "run_program.h"

using namespace whittle;

namespace {

constexpr std::uint64_t kMega = 1 << 20;
constexpr std::uint64_t kUnknown = std::numeric_limits<std::uint64_t>::max();

// Files under a folder of their own, as the kernel shows them.
class Kernel {
public:
    explicit Kernel(const std::string& groups) {
        write("proc/meminfo", "MemTotal:       8388608 kB\nMemFree:         1024 kB\nMemAvailable:   4194304 kB\n");
        write("proc/self/cgroup", groups);
    }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder_.path() / name).parent_path());
        folder_.file(name, text);
    }
    std::uint64_t left() const { return available_bytes(folder_.path().string()); }

private:
    TemporaryFolder folder_;
};

// Runs the program where /proc/meminfo says that so many kilobytes are left, whatever the run takes.
Outcome run_with_memory(const TemporaryFolder& folder, const std::string& kilobytes, const std::string& words) {
    folder.file("meminfo", "MemAvailable: " + kilobytes + " kB\n");
    return run_program("/bin/sh", {"-c", "unshare -rm sh -c 'mount --bind meminfo /proc/meminfo && exec " WHITTLE_PROGRAM " " + words + "'"},
                       {"", folder.path().string(), 0, ""});
}

}  // namespace

TEST_CASE("what is left is the least of the system's and of every memory group's around the run") {
    const Kernel bare("");
    CHECK(bare.left() == 4096 * kMega);
    const Kernel second("0::/user/run\n");
    CHECK(second.left() == 4096 * kMega);  // groups without a limit
    second.write("sys/fs/cgroup/user/run/memory.max", "max\n");
    second.write("sys/fs/cgroup/user/run/memory.current", "1048576\n");
    CHECK(second.left() == 4096 * kMega);
    second.write("sys/fs/cgroup/user/memory.max", "1073741824\n");
    second.write("sys/fs/cgroup/user/memory.current", "536870912\n");
    CHECK(second.left() == 512 * kMega);
    second.write("sys/fs/cgroup/user/memory.stat", "anon 1\ninactive_file 104857600\nactive_file 1048576\n");
    CHECK(second.left() == 613 * kMega);
    second.write("sys/fs/cgroup/memory.max", "1048576\n");  // the container's own
    second.write("sys/fs/cgroup/memory.current", "2097152\n");
    CHECK(second.left() == 0);
}

TEST_CASE("memory groups of the first version count, and a path that only the host knows is passed over") {
    const Kernel first("5:cpu,cpuacct:/a\n4:memory:/docker/0123\n1:name=systemd:/b\n");
    CHECK(first.left() == 4096 * kMega);
    first.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "1073741824\n");
    first.write("sys/fs/cgroup/memory/memory.usage_in_bytes", "209715200\n");
    CHECK(first.left() == 824 * kMega);
    first.write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
    CHECK(first.left() == 4096 * kMega);
}

TEST_CASE("a run leaves a tenth, and goes on where others hold the memory") {
    CHECK(memory_left(1000, 9000) == 8000);
    CHECK(memory_left(9000, 1000) == 0);
    CHECK(memory_left(9001, 999) == 0);
    CHECK(memory_left(50 * kMega, 20 * kMega) == 13 * kMega);
    CHECK(memory_left(1, kUnknown) == kUnknown);
    CHECK(wait_for_memory_ms(0) == 20);
    CHECK(wait_for_memory_ms(800'000'000) == 100);
    CHECK(wait_for_memory_ms(kUnknown) == 500);
}

TEST_CASE("without a limit a run ends before it is killed, whatever it fills the memory with") {
    const TemporaryFolder folder;
    if (run_with_memory(folder, "1000000", "--version").code != 0) {
        WARN("no name space of mounts here: the default limit is tested by its parts only");
        return;
    }
    folder.file("lists.scad", "a = [for (i = [0:999998]) [for (j = [0:999]) i]];\n");
    folder.file("doubled.scad", "function grow(v) = grow(concat(v, v));\na = grow([1, 2, 3]);\n");
    folder.file("texts.scad", "a = [for (i = [0:999998]) [for (j = [0:99]) str(i, \"012345678901234567890123456789\", j)]];\n");
    folder.file("places.scad", "for (i = [0:9000]) for (j = [0:999]) translate([i, j, 0]) cube(0.5);\n");
    folder.file("facets.scad", "$fn = 3000; sphere(10);\n");
    folder.file("ball.scad", "sphere(100);\n");
    for (const char* words : {"measure lists.scad", "check doubled.scad", "render texts.scad -o a.png", "-o a.echo lists.scad", "measure places.scad", "mesh facets.scad -o a.stl",
                              "mesh ball.scad -o a.stl --tolerance 1e-5", "render ball.scad -o a.exr --imgsize 12000,12000 --samples 1"}) {
        const Outcome run = run_with_memory(folder, "20000", words);
        INFO(words << "\n" << run.err);
        CHECK(run.code == 3);
        CHECK(contains(run.err, "memory"));
    }
    CHECK(folder.names().size() == 7);  // the six scenes and meminfo: nothing written
    const Outcome lifted = run_with_memory(folder, "20000", "measure lists.scad --limit-memory none --limit-time 0.5");
    INFO(lifted.err);
    CHECK(contains(lifted.err, "time limit"));
}

TEST_CASE("memory that the system refuses ends the run with a message and 3") {
    const TemporaryFolder folder;
    folder.file("lists.scad", "a = [for (i = [0:999998]) [for (j = [0:999]) i]];\n");
    folder.file("ball.scad", "sphere(100);\n");
    for (const char* words : {"measure lists.scad", "mesh ball.scad -o a.stl --tolerance 1e-5", "render ball.scad -o a.exr --imgsize 12000,12000 --samples 1"}) {
        const Outcome run = run_program("/bin/sh", {"-c", std::string("ulimit -v 1800000; exec " WHITTLE_PROGRAM " ") + words + " --limit-memory none"}, {"", folder.path().string(), 0, ""});
        INFO(words << "\n" << run.err);
        CHECK(run.code == 3);
        CHECK(contains(run.err, "memory"));
    }
}
