#include "files/write_file.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <system_error>

namespace slicecast {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error);
}

// 0 on success, else errno. `prepare` is called while the file is still empty.
template <class Prepare>
int writeBytes(const fs::path& path, std::span<const std::uint8_t> bytes, Prepare prepare) {
    // A stream, unlike fopen, takes a path on every system.
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    if (!file) return errno;
    prepare();
    errno = 0;
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    file.close();
    return file ? 0 : errno;
}

// The name of a temporary file beside `path`. Two programs that write the same file at once use
// different ones.
fs::path partBeside(fs::path path) {
    path += ".part-" + std::to_string(std::random_device{}());
    return path;
}

// Writes a temporary file beside `path` and renames it when all is written. 0 on success, else
// errno.
int replaceFile(const fs::path& path, const fs::file_status& old,
                std::span<const std::uint8_t> bytes) {
    const fs::path part = partBeside(path);
    std::error_code error;
    int fault = writeBytes(part, bytes, [&] {
        if (fs::exists(old)) fs::permissions(part, old.permissions(), error);
    });
    if (fault == 0) {
        fs::rename(part, path, error);
        fault = error.value();
    }
    if (fault != 0) fs::remove(part, error);
    return fault;
}

// The end of a chain of links, whether or not it exists.
fs::path followLinks(fs::path path) {
    constexpr int kMostLinks = 40;  // as many as Linux follows
    std::error_code error;
    for (int links = 0; links < kMostLinks && fs::is_symlink(path, error); ++links)
        path = path.parent_path() / fs::read_symlink(path, error);
    return path;
}

bool isFileOrNothing(const fs::file_status& status) {
    return fs::is_regular_file(status) || status.type() == fs::file_type::not_found;
}

std::string isFolder(const std::string& path) {
    return "\"" + path + "\" is a folder; expected the name of a file";
}

// Empty without a fault.
std::string cannotBeWritten(const std::string& path, int fault) {
    return fault == 0 ? std::string() : "\"" + path + "\" cannot be written: " + reason(fault);
}

}  // namespace

std::string writeWholeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) return isFolder(path);
    return cannotBeWritten(path, isFileOrNothing(status)
                                     ? replaceFile(followLinks(path), status, bytes)
                                     : writeBytes(path, bytes, [] {}));
}

std::string whyNotWritable(const std::string& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) return isFolder(path);
    if (!isFileOrNothing(status)) return {};
    const fs::path part = partBeside(followLinks(path));
    const int fault = writeBytes(part, {}, [] {});
    fs::remove(part, error);
    return cannotBeWritten(path, fault);
}

void outliveClosedPipes() {
#ifdef SIGPIPE  // Windows has none: there such a write just fails
    std::signal(SIGPIPE, SIG_IGN);
#endif
}

int finishOutput(const char* program, int status) {
    errno = 0;
    const bool isLost = std::fflush(stdout) != 0;
    const int fault = errno;
    if (!isLost && std::ferror(stdout) == 0) return status;
    const std::string cause = fault == 0 ? std::string() : ": " + reason(fault);
    std::fprintf(stderr, "%s: cannot write the standard output%s\n", program, cause.c_str());
    return 1;
}

std::string writeWholeFile(const std::string& path, std::string_view text) {
    return writeWholeFile(
        path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace slicecast
