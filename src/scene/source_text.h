// The text of a scene file: checks its UTF-8, and finds the line and column of a byte.
//
// Offsets count bytes from 0. Lines and columns count from 1; a column is one character (code
// point), whatever its bytes. A line ends at "\n", "\r\n" or a lone "\r". A byte order mark at the
// start does not count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slicecast {

// A place in the text as an editor shows it.
struct TextPosition {
    int line = 1;
    int column = 1;
};

class SourceText {
public:
    // The text must outlive this. It is read once, whole.
    explicit SourceText(std::string_view text);

    std::string_view text() const { return text_; }

    // The text behind a byte order mark, if there is one, starts here.
    std::size_t start() const { return start_; }

    // The first byte that is not UTF-8, if any.
    std::optional<std::size_t> invalidByte() const { return invalidByte_; }

    // Where a byte stands. Bytes behind an invalid one count as a character each.
    TextPosition place(std::size_t offset) const;

    // The offset of character `index` (from 0) of the JSON string whose opening quote stands at
    // `quote`; an escape sequence is one character.
    std::size_t characterOffset(std::size_t quote, int index) const;

private:
    struct Mark {
        std::size_t offset;
        TextPosition place;
    };

    // The mark moved on over the character at its offset.
    Mark next(Mark mark) const;

    std::string_view text_;
    std::size_t start_ = 0;
    std::optional<std::size_t> invalidByte_;
    std::vector<Mark> marks_;  // every few hundred bytes, so that looking up a place never reads
                               // the whole text again
};

// The number of bytes of the well-formed UTF-8 character at `offset`, or 0 if there is none.
int utf8Length(std::string_view text, std::size_t offset);

// The code point at `offset`, which is moved behind it. The text must be well-formed there.
char32_t takeCodePoint(std::string_view text, std::size_t& offset);

// The sign at `offset`, which is moved behind it: what people see as one character. Most are one
// code point. Accents, shades, keycaps and the like belong to the code point before them, a flag is
// two regional letters, and a joiner (U+200D) takes a symbol behind it. The text must be
// well-formed there. web/engine/signs.js has the same rule.
std::string_view takeSign(std::string_view text, std::size_t& offset);

// The number of signs of well-formed UTF-8.
std::size_t countSigns(std::string_view text);

// The number of characters of well-formed UTF-8.
std::size_t countCharacters(std::string_view text);

// The bytes of a code point.
std::string toUtf8(char32_t codePoint);

// True for what a person can see and type as one character: no control characters, no spaces,
// nothing that joins the character before it or behind it.
bool isPrintable(char32_t codePoint);
bool isPrintableSign(std::string_view sign);

// "U+2764 U+FE0F"
std::string codePointsOf(std::string_view text);

}  // namespace slicecast
