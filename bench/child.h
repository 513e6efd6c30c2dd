// child.h — other programs: started, waited for, and what they cost.
#pragma once

#include <string>
#include <vector>

namespace whittle::bench {

struct ChildRun {
    double wall_s = 0, user_s = 0, system_s = 0;
    long kilobytes = 0;   // most memory at once
    bool good = false;    // it ended with `accepted` or 0
    bool in_time = true;  // false: it was ended for its processor time
    double cpu_s() const { return user_s + system_s; }
};

struct ChildLimits {
    double cpu_s = 0;   // 0: none
    int accepted = 0;   // an exit code that is as good as 0
};

// words[0] is looked up on the path. What it says is thrown away, or goes to the file `output`.
ChildRun run_child(std::vector<std::string> words, const std::string& output = "/dev/null", const ChildLimits& limits = {});

// A folder of one's own under the system's, gone with its object. path() is empty where none could be made.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace whittle::bench
