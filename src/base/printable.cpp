#include "base/printable.h"

#include <algorithm>
#include <cstddef>

namespace slicecast {
namespace {

// The length of the character that begins the text, in bytes: 0 if none does.
std::size_t characterLength(std::string_view text) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80   ? 1
                               : first < 0xc2 ? 0
                               : first < 0xe0 ? 2
                               : first < 0xf0 ? 3
                               : first < 0xf5 ? 4
                                              : 0;
    if (length > text.size()) return 0;
    const auto isFurther = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };
    return std::all_of(text.begin() + 1, text.begin() + std::max<std::size_t>(length, 1), isFurther)
               ? length
               : 0;
}

// U+0000 to U+001F, U+007F to U+009F.
bool isControl(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    return first < 0x20 || first == 0x7f ||
           (first == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0);
}

}  // namespace

std::string printable(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t length = characterLength(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        shown += length == 0 || isControl(character) ? "?" : character;
        text.remove_prefix(character.size());
    }
    return shown;
}

}  // namespace slicecast
