#include "headless/view_arguments.h"

#include "render/options.h"
#include "slicecast/picture.h"
#include "world/player.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace slicecast {
namespace {

std::string quoted(std::string_view text) {
    return "\"" + std::string(text) + "\"";
}

// The whole text must be a decimal number.
std::optional<double> readNumber(const std::string& text) {
    if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos)
        return std::nullopt;
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return end == text.c_str() + text.size() && std::isfinite(number) ? std::optional(number)
                                                                      : std::nullopt;
}

// A number from `least` to `greatest`, at most 5 digits and nothing else.
std::optional<int> readWhole(const std::string& text, int least, int greatest) {
    if (text.empty() || text.size() > 5 ||
        text.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    const int number = std::atoi(text.c_str());
    return number >= least && number <= greatest ? std::optional(number) : std::nullopt;
}

// A range for one of the five numbers of an eye.
struct EyeNumber {
    const char* name;
    double least;
    double greatest;
};
constexpr std::array kEyeNumbers = {
    EyeNumber{"X", -kCoordinateLimit, kCoordinateLimit},
    EyeNumber{"Y", -kCoordinateLimit, kCoordinateLimit},
    EyeNumber{"Z", -kCoordinateLimit, kCoordinateLimit},
    EyeNumber{"HEADING", -1e9, 1e9},
    EyeNumber{"LOOK", -kMaxLook, kMaxLook},
};

}  // namespace

Read<PictureSize> readSize(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross != std::string::npos) {
        const std::optional<int> width = readWhole(text.substr(0, cross), 1, kMaxPictureSide);
        const std::optional<int> height = readWhole(text.substr(cross + 1), 1, kMaxPictureSide);
        if (width && height) return {PictureSize{*width, *height}, {}};
    }
    const std::string largest = std::to_string(kMaxPictureSide);
    return {std::nullopt, "found " + quoted(text) + ", expected WxH in pixels, from 1x1 to " +
                              largest + "x" + largest};
}

Read<int> readColumn(const std::string& text, int width) {
    const std::optional<int> column = readWhole(text, 0, width - 1);
    if (column) return {column, {}};
    return {std::nullopt, "found " + quoted(text) + ", expected a column of the picture, 0 to " +
                              std::to_string(width - 1)};
}

Read<int> readTime(const std::string& text) {
    constexpr double kLongest = 3600.0;
    const std::optional<double> seconds = readNumber(text);
    if (seconds && *seconds >= 0.0 && *seconds <= kLongest)
        return {static_cast<int>(std::floor(*seconds * kStepsPerSecond + 0.5)), {}};
    return {std::nullopt, "found " + quoted(text) + ", expected seconds, from 0 to 3600"};
}

Read<Eye> readEye(const std::string& text, int map) {
    std::array<double, kEyeNumbers.size()> numbers{};
    std::size_t begin = 0;
    for (std::size_t i = 0; i < kEyeNumbers.size(); ++i) {
        const bool isLast = i + 1 == kEyeNumbers.size();
        const std::size_t comma = text.find(',', begin);
        if ((comma == std::string::npos) != isLast)
            return {std::nullopt,
                    "found " + quoted(text) + ", expected five numbers X,Y,Z,HEADING,LOOK"};
        const std::string part =
            text.substr(begin, comma == std::string::npos ? comma : comma - begin);
        const std::optional<double> number = readNumber(part);
        const EyeNumber& limits = kEyeNumbers[i];
        if (!number || *number < limits.least || *number > limits.greatest) {
            char expected[96];
            std::snprintf(expected, sizeof expected, ", expected a number from %.10g to %.10g",
                          limits.least, limits.greatest);
            return {std::nullopt, std::string(limits.name) + ": found " + quoted(part) + expected};
        }
        numbers[i] = *number;
        begin = comma + 1;
    }
    const Eye eye = {map,
                     toCoordinate(numbers[0]),
                     toCoordinate(numbers[1]),
                     toCoordinate(numbers[2]),
                     numbers[3],
                     numbers[4]};
    if (!isAboveFloor(eye)) {
        char found[64];
        std::snprintf(found, sizeof found, "%.10g", numbers[2]);
        return {std::nullopt, "Z: found " + std::string(found) +
                                  ", expected a height above the floor (which is at 0): an eye at "
                                  "or below the floor sees nothing"};
    }
    return {eye, {}};
}

}  // namespace slicecast
