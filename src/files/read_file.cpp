#include "files/read_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

namespace slicecast {
namespace {

namespace fs = std::filesystem;

ReadFile failed(std::string fault) {
    return {{}, std::move(fault)};
}

ReadFile unreadable(const std::error_code& error) {
    return failed("cannot be read: " + (error ? error.message() : "the disk gives no bytes"));
}

ReadFile tooLarge(std::uintmax_t bytes, std::uintmax_t maxBytes) {
    return failed("has " + std::to_string(bytes) + " bytes; at most " + std::to_string(maxBytes) +
                  " are read");
}

// Empty for a regular file, else what the path is instead.
std::string whyNotRegular(const fs::path& path) {
    std::error_code error;
    switch (fs::status(path, error).type()) {
        case fs::file_type::regular:
            return {};
        case fs::file_type::not_found:
            return kNoSuchFile;
        case fs::file_type::directory:
            return "is a folder";
        case fs::file_type::none:
            return unreadable(error).fault;
        default:
            return "is not a regular file";
    }
}

}  // namespace

ReadFile readWholeFile(const fs::path& path, std::uintmax_t maxBytes) {
    std::string fault = whyNotRegular(path);
    if (!fault.empty()) return failed(std::move(fault));
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) return unreadable(error);
    if (size > maxBytes) return tooLarge(size, maxBytes);

    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return unreadable({errno, std::generic_category()});
    // Read to the end, whatever the size was: some files grow meanwhile, and some report 0 bytes.
    constexpr std::uintmax_t kBlock = 1u << 16;
    ReadFile file;
    file.bytes.reserve(static_cast<std::size_t>(size));
    while (stream && file.bytes.size() <= maxBytes) {
        const std::size_t length = file.bytes.size();
        const auto chunk = static_cast<std::size_t>(std::max(kBlock, size));
        file.bytes.resize(length + chunk);
        stream.read(reinterpret_cast<char*>(file.bytes.data() + length),
                    static_cast<std::streamsize>(chunk));
        file.bytes.resize(length + static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.bad()) return unreadable({errno, std::generic_category()});
    if (file.bytes.size() > maxBytes) return tooLarge(file.bytes.size(), maxBytes);
    return file;
}

fs::path pathOf(const std::string& name) {
    return {reinterpret_cast<const char8_t*>(name.c_str())};
}

}  // namespace slicecast
