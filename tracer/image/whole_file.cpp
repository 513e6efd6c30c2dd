// whole_file.cpp — a file is written whole or not at all.
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "tracer/image/image_file.h"

namespace whittle {

namespace {

// 0, or the errno of the first write that failed.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? errno : ENOSPC;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int write_and_close(int file, std::string_view bytes) {
    const int failed = write_all(file, bytes);
    const int unclosed = ::close(file) == 0 ? 0 : errno;
    return failed ? failed : unclosed;
}

tl::unexpected<Error> refused(const std::filesystem::path& path, int error) {
    return fail(Fault::kWorld, fmt::format("Can't write '{}': {}", path.string(), std::strerror(error)));
}

}  // namespace

Result<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
    struct stat old{};
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (exists && !S_ISREG(old.st_mode)) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (file < 0) return refused(path, errno);
        if (const int failed = write_and_close(file, bytes)) return refused(path, failed);
        return {};
    }
    std::error_code ignored;
    const std::filesystem::path target = exists ? std::filesystem::canonical(path, ignored) : path;
    std::filesystem::path temporary = target;
    temporary.replace_filename(fmt::format(".{}.{}.part", target.filename().string(), ::getpid()));
    const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, exists ? old.st_mode & 0777 : 0666);
    if (file < 0) return refused(path, errno);
    int failed = write_and_close(file, bytes);
    if (!failed && ::rename(temporary.c_str(), target.c_str()) != 0) failed = errno;
    if (!failed) return {};
    ::unlink(temporary.c_str());
    return refused(path, failed);
}

}  // namespace whittle
