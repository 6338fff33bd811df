#include "files/write_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <system_error>

namespace slicecast {
namespace {

std::string reason(int error) {
    return std::generic_category().message(error);
}

}  // namespace

std::string writeWholeFile(const std::string& path, std::span<const std::uint8_t> bytes) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        return "\"" + path + "\" is a folder; expected the name of a file";

    // Two that write the same file at once each have a part of their own.
    const std::string part = path + ".part-" + std::to_string(std::random_device{}());
    std::FILE* file = std::fopen(part.c_str(), "wb");
    if (file == nullptr) return "\"" + path + "\" cannot be written: " + reason(errno);
    int fault = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
    if (std::fclose(file) != 0 && fault == 0) fault = errno;
    if (fault == 0) {
        std::filesystem::rename(part, path, error);
        fault = error.value();
    }
    if (fault == 0) return {};
    std::filesystem::remove(part, error);
    return "\"" + path + "\" cannot be written: " + reason(fault);
}

std::string writeWholeFile(const std::string& path, std::string_view text) {
    return writeWholeFile(
        path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace slicecast
