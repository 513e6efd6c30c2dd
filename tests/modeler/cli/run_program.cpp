// run_program.cpp — see run_program.h.
#include "run_program.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

// A file that has no name, for a stream of the child.
int nameless_file(const std::string& content) {
    std::string pattern = (std::filesystem::temp_directory_path() / "whittle-test-XXXXXX").string();
    const int file = mkstemp(pattern.data());
    if (file < 0) throw std::runtime_error("mkstemp");
    unlink(pattern.c_str());
    if (write(file, content.data(), content.size()) != static_cast<ssize_t>(content.size())) throw std::runtime_error("write");
    lseek(file, 0, SEEK_SET);
    return file;
}

std::string content_of(int file) {
    lseek(file, 0, SEEK_SET);
    std::string text;
    std::array<char, 65536> piece{};
    for (ssize_t n = read(file, piece.data(), piece.size()); n > 0; n = read(file, piece.data(), piece.size())) text.append(piece.data(), static_cast<std::size_t>(n));
    return text;
}

}  // namespace

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments, const RunOptions& options) {
    const int in = nameless_file(options.input), err = nameless_file("");
    const int out = options.output_file.empty() ? nameless_file("") : open(options.output_file.c_str(), O_WRONLY);
    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(126);
        dup2(in, 0);
        dup2(out, 1);
        dup2(err, 2);
        execv(program.c_str(), argv.data());
        _exit(127);
    }
    if (options.interrupt_after_s > 0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(options.interrupt_after_s));
        kill(child, SIGINT);
    }
    int status = 0;
    waitpid(child, &status, 0);
    Outcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (options.output_file.empty()) outcome.out = content_of(out);
    outcome.err = content_of(err);
    for (const int file : {in, out, err}) close(file);
    return outcome;
}

Outcome run_whittle(const std::vector<std::string>& arguments, const RunOptions& options) { return run_program(WHITTLE_PROGRAM, arguments, options); }

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "whittle-test-XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("mkdtemp");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::file(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return (path_ / name).string();
}

std::string TemporaryFolder::read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path_ / name, std::ios::binary).rdbuf();
    return text.str();
}

std::vector<std::string> TemporaryFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
