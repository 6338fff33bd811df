#include "base/words.h"

namespace slicecast {

template <typename Take>
void Word::say(Take take) const {
    switch (kind_) {
        case kText:
            take(std::string_view(text_, static_cast<std::size_t>(whole_)));
            break;
        case kTextToZero:
            take(std::string_view(text_));
            break;
        case kCounted:
        case kWhole:
            take(wholeText(whole_));
            if (kind_ == kWhole) break;
            take(" ");
            take(std::string_view(text_));
            if (whole_ != 1) take("s");
            break;
        default:
            take(kind_ == kShortest ? shortestText(number_) : fixedText(number_, kind_));
    }
}

void add(std::string& text, const Words& words) {
    for (const Word& word : words) word.say([&](std::string_view said) { text += said; });
}

std::string Words::str() const {
    std::string text;
    add(text, *this);
    return text;
}

std::string_view write(std::span<char> place, const Words& words) {
    std::size_t length = 0;
    for (const Word& word : words) {
        word.say([&](std::string_view said) {
            length += said.copy(place.data() + length, place.size() - length);
        });
    }
    return {place.data(), length};
}

}  // namespace slicecast
