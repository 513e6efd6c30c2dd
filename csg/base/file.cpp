// file.cpp — see file.h. POSIX calls, because the standard streams keep neither the reason of a failure nor the time of it.
#include "csg/base/file.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace whittle {

namespace {

tl::unexpected<Error> fail_with_reason(const char* what, const std::string& path, int reason) {
    return fail(Fault::kWorld, std::string(what) + " '" + path + "': " + std::strerror(reason));
}

// 0, or errno of the first failure.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int write_and_close(int file, std::string_view bytes) {
    int reason = write_all(file, bytes);
    if (::close(file) != 0 && reason == 0) reason = errno;
    return reason;
}

// What `path` leads to when it is a link to something that exists, else `path`.
std::string resolved(const std::string& path) {
    char* real = ::realpath(path.c_str(), nullptr);
    if (!real) return path;
    std::string result(real);
    std::free(real);
    return result;
}

}  // namespace

std::string temporary_name(const std::string& path) {
    const std::string target = resolved(path);
    const auto slash = target.rfind('/');
    const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
    return target.substr(0, name) + "." + target.substr(name) + ".whittle-" + std::to_string(::getpid());
}

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
    const std::string target = resolved(path);
    struct stat old {};
    const bool exists = ::stat(target.c_str(), &old) == 0;
    if (exists && !S_ISREG(old.st_mode)) {
        const int file = ::open(target.c_str(), O_WRONLY | O_CLOEXEC);
        const int reason = file < 0 ? errno : write_and_close(file, bytes);
        if (reason != 0) return fail_with_reason("cannot write", path, reason);
        return {};
    }
    if (exists && ::access(target.c_str(), W_OK) != 0) return fail_with_reason("cannot write", path, errno);
    const std::string temporary = temporary_name(target);
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, exists ? old.st_mode & 07777 : 0666);
    if (file < 0) return fail_with_reason("cannot write", path, errno);
    int reason = write_and_close(file, bytes);
    if (reason == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) reason = errno;
    if (reason == 0) return {};
    ::unlink(temporary.c_str());
    return fail_with_reason("cannot write", path, reason);
}

Result<std::string> read_whole_file(const std::string& path) {
    const bool standard_input = path == "-";
    const int file = standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return fail_with_reason("cannot read", path, errno);
    std::string bytes;
    constexpr std::size_t kStep = 1 << 16;
    int reason = 0;
    while (true) {
        const std::size_t size = bytes.size();
        bytes.resize(size + kStep);
        const ssize_t count = ::read(file, bytes.data() + size, kStep);
        const int fault = errno;
        bytes.resize(size + (count > 0 ? static_cast<std::size_t>(count) : 0));
        if (count == 0) break;
        if (count < 0 && fault == EINTR) continue;
        if (count < 0 && (reason = fault) != 0) break;
    }
    if (!standard_input) ::close(file);
    if (reason != 0) return fail_with_reason("cannot read", path, reason);
    return bytes;
}

}  // namespace whittle
