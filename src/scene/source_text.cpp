#include "scene/source_text.h"

#include "base/number_text.h"
#include "base/words.h"

#include <algorithm>
#include <utility>

namespace slicecast {
namespace {

constexpr std::size_t kBytesPerMark = 256;
constexpr int kMostJoined = 15;  // to one code point; the longest emoji have 9
constexpr char32_t kJoiner = 0x200d;

unsigned char byteAt(std::string_view text, std::size_t offset) {
    return static_cast<unsigned char>(text[offset]);
}

constexpr bool isWithin(char32_t c, char32_t first, char32_t last) {
    return c >= first && c <= last;
}

// Two of these letters are a flag.
bool isRegional(char32_t c) {
    return isWithin(c, 0x1f1e6, 0x1f1ff);
}

// What belongs to the code point before it, from the first to the last one of each range.
constexpr std::pair<char32_t, char32_t> kJoining[] = {
    {0x300, 0x36f},     {0x483, 0x489},     {0x1ab0, 0x1aff},  {0x1dc0, 0x1dff},
    {kJoiner, kJoiner}, {0x20d0, 0x20ff},   {0x3099, 0x309a},  {0xfe00, 0xfe0f},
    {0xfe20, 0xfe2f},   {0x1f3fb, 0x1f3ff}, {0xe0000, 0xe0fff}};

bool joins(char32_t c) {
    for (const auto& [first, last] : kJoining) {
        if (isWithin(c, first, last)) return true;
    }
    return false;
}

bool isContinuation(std::string_view text, std::size_t offset) {
    return offset < text.size() && (byteAt(text, offset) & 0xc0) == 0x80;
}

}  // namespace

int utf8Length(std::string_view text, std::size_t offset) {
    const unsigned char first = byteAt(text, offset);
    if (first < 0x80) return 1;
    if (first < 0xc2 || first > 0xf4 || !isContinuation(text, offset + 1)) return 0;
    if (first < 0xe0) return 2;
    // Overlong forms, surrogates and code points beyond the last one show in the second byte.
    const unsigned char second = byteAt(text, offset + 1);
    if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second >= 0xa0)) return 0;
    if ((first == 0xf0 && second < 0x90) || (first == 0xf4 && second >= 0x90)) return 0;
    if (!isContinuation(text, offset + 2)) return 0;
    if (first < 0xf0) return 3;
    return isContinuation(text, offset + 3) ? 4 : 0;
}

char32_t takeCodePoint(std::string_view text, std::size_t& offset) {
    const unsigned char first = byteAt(text, offset++);
    if (first < 0x80) return first;
    const int more = first < 0xe0 ? 1 : first < 0xf0 ? 2 : 3;
    char32_t codePoint = first & (0x3fu >> more);
    for (int i = 0; i < more; ++i) codePoint = codePoint << 6 | (byteAt(text, offset++) & 0x3fu);
    return codePoint;
}

std::string_view takeSign(std::string_view text, std::size_t& offset) {
    const std::size_t start = offset;
    // Moves on if the next code point is a fitting one.
    const auto take = [&](auto fits) {
        std::size_t next = offset;
        if (next == text.size() || !fits(takeCodePoint(text, next))) return false;
        offset = next;
        return true;
    };
    const char32_t first = takeCodePoint(text, offset);
    if (offset == text.size() || byteAt(text, offset) < 0x80)
        return text.substr(start, offset - start);
    if (isRegional(first)) take(isRegional);
    for (int joined = 0; joined < kMostJoined; ++joined) {
        if (take([](char32_t c) { return c == kJoiner; })) {
            take([](char32_t c) { return isWithin(c, 0x2100, 0x1ffff); });
        } else if (!take(joins)) {
            break;
        }
    }
    return text.substr(start, offset - start);
}

std::size_t countSigns(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t offset = 0; offset < text.size(); ++count) takeSign(text, offset);
    return count;
}

std::size_t countCharacters(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
    }));
}

std::string toUtf8(char32_t codePoint) {
    const auto byte = [](char32_t bits) {
        return static_cast<char>(static_cast<unsigned char>(bits));
    };
    const auto tail = [&](int shift) { return byte(0x80 | (codePoint >> shift & 0x3f)); };
    if (codePoint < 0x80) return {byte(codePoint)};
    if (codePoint < 0x800) return {byte(0xc0 | codePoint >> 6), tail(0)};
    if (codePoint < 0x10000) return {byte(0xe0 | codePoint >> 12), tail(6), tail(0)};
    return {byte(0xf0 | codePoint >> 18), tail(12), tail(6), tail(0)};
}

bool isPrintable(char32_t c) {
    const auto within = [c](char32_t first, char32_t last) { return isWithin(c, first, last); };
    const bool control = c <= 0x20 || within(0x7f, 0xa0) || c == 0xad || within(0x200b, 0x200f) ||
                         within(0x2028, 0x202f) || within(0x2060, 0x206f);
    const bool space = within(0x2000, 0x200a) || c == 0x205f || c == 0x3000 || c == 0x1680;
    const bool noCharacter = within(0xd800, 0xf8ff) || c == 0xfeff || within(0xfff0, 0xfffb) ||
                             (c & 0xfffe) == 0xfffe || within(0xfdd0, 0xfdef) || c > 0xeffff;
    return !control && !joins(c) && !space && !noCharacter;
}

bool isPrintableSign(std::string_view sign) {
    std::size_t end = 0;
    const char32_t first = takeCodePoint(sign, end);
    // Half a flag, and what ends with a joiner, would take the next sign in.
    const bool isOpen = (isRegional(first) && end == sign.size()) || sign.ends_with("\u200d");
    return isPrintable(first) && !isOpen;
}

std::string codePointsOf(std::string_view text) {
    std::string list;
    for (std::size_t offset = 0; offset < text.size();) {
        const char32_t c = takeCodePoint(text, offset);
        std::string digits(hexText(c, c > 0xfffff ? 6 : c > 0xffff ? 5 : 4));
        for (char& digit : digits) {
            if (digit >= 'a') digit = static_cast<char>(digit - 'a' + 'A');
        }
        add(list, {list.empty() ? "U+" : " U+", digits});
    }
    return list;
}

SourceText::SourceText(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xef\xbb\xbf") start_ = 3;
    Mark mark{start_, {}};
    marks_.push_back(mark);
    while (mark.offset < text_.size()) {
        if (!invalidByte_ && utf8Length(text_, mark.offset) == 0) invalidByte_ = mark.offset;
        mark = next(mark);
        if (mark.offset >= marks_.back().offset + kBytesPerMark) marks_.push_back(mark);
    }
}

SourceText::Mark SourceText::next(Mark mark) const {
    const char c = text_[mark.offset];
    const bool endsLine = c == '\n' || (c == '\r' && text_.substr(mark.offset + 1, 1) != "\n");
    if (endsLine) {
        ++mark.place.line;
        mark.place.column = 1;
    } else if (c != '\r') {
        ++mark.place.column;
    }
    mark.offset += static_cast<std::size_t>(std::max(1, utf8Length(text_, mark.offset)));
    return mark;
}

TextPosition SourceText::place(std::size_t offset) const {
    const auto behind =
        std::upper_bound(marks_.begin(), marks_.end(), offset,
                         [](std::size_t value, const Mark& mark) { return value < mark.offset; });
    if (behind == marks_.begin()) return {};
    Mark mark = *(behind - 1);
    while (mark.offset < std::min(offset, text_.size())) mark = next(mark);
    return mark.place;
}

std::size_t SourceText::characterOffset(std::size_t quote, int index) const {
    std::size_t offset = quote + 1;
    const auto isUnicodeEscape = [&](std::size_t at) { return text_.substr(at, 2) == "\\u"; };
    const auto hexDigits = [&](std::size_t at) {
        return text_.substr(std::min(at, text_.size()), 2);
    };
    for (int i = 0; i < index && offset < text_.size(); ++i) {
        if (isUnicodeEscape(offset)) {
            // A code point beyond 16 bits is written as two escapes; the first lies in D800 to
            // DBFF.
            const std::string_view high = hexDigits(offset + 2);
            const bool isPair = high.size() == 2 && (high[0] == 'd' || high[0] == 'D') &&
                                std::string_view("89aAbB").find(high[1]) != std::string_view::npos;
            offset += isPair ? 12 : 6;
        } else if (text_[offset] == '\\') {
            offset += 2;
        } else {
            offset += static_cast<std::size_t>(std::max(1, utf8Length(text_, offset)));
        }
    }
    return std::min(offset, text_.size());
}

}  // namespace slicecast
