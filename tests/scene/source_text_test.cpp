#include "scene/source_text.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace slicecast {
namespace {

std::string placeOf(const SourceText& source, std::size_t offset) {
    const TextPosition place = source.place(offset);
    return std::to_string(place.line) + ":" + std::to_string(place.column);
}

TEST(SourceText, CountsLinesAndCharacters) {
    const std::string text = "ab\n\xc3\xa9\xf0\x9f\xa7\xb1z\r\n\rq\n";
    const SourceText source(text);
    EXPECT_EQ(placeOf(source, 0), "1:1");
    EXPECT_EQ(placeOf(source, 1), "1:2");
    EXPECT_EQ(placeOf(source, 2), "1:3");   // the line's own end
    EXPECT_EQ(placeOf(source, 3), "2:1");   // 2 bytes
    EXPECT_EQ(placeOf(source, 5), "2:2");   // 4 bytes
    EXPECT_EQ(placeOf(source, 9), "2:3");   // z
    EXPECT_EQ(placeOf(source, 12), "3:1");  // the lone \r
    EXPECT_EQ(placeOf(source, 13), "4:1");  // q
    EXPECT_EQ(placeOf(source, text.size()), "5:1");
    EXPECT_EQ(placeOf(source, text.size() + 100), "5:1");
}

TEST(SourceText, DoesNotCountAByteOrderMark) {
    const SourceText source("\xef\xbb\xbf{}");
    EXPECT_EQ(source.start(), 3u);
    EXPECT_EQ(placeOf(source, 3), "1:1");
    EXPECT_EQ(placeOf(source, 0), "1:1");
}

TEST(SourceText, FindsPlacesInLongTexts) {
    // Counted one character after the other, against the looked-up places.
    Random random(7);
    std::string text;
    while (text.size() < 20'000) {
        const char* parts[] = {"a",
                               "\n",
                               "\r\n",
                               "\xc3\xa9",
                               "\xe2\x96\x88",
                               "\xf0\x9f\xa7\xb1",
                               "a long piece of text",
                               "\r"};
        text += parts[random.below(8)];
    }
    const SourceText source(text);
    int line = 1;
    int column = 1;
    for (std::size_t offset = 0; offset < text.size();) {
        ASSERT_EQ(placeOf(source, offset), std::to_string(line) + ":" + std::to_string(column))
            << offset;
        const bool endsLine =
            text[offset] == '\n' || (text[offset] == '\r' && text[offset + 1] != '\n');
        if (endsLine) {
            ++line;
            column = 1;
        } else if (text[offset] != '\r') {
            ++column;
        }
        takeCodePoint(text, offset);
    }
}

TEST(SourceText, DetectsInvalidUtf8) {
    for (const char* sound : {"", "plain", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf",
                              "\xee\x80\x80", "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf"}) {
        EXPECT_FALSE(SourceText(sound).invalidByte().has_value()) << sound;
    }
    const std::string_view faulty[] = {"ab\x80",
                                       "ab\xc3",
                                       "ab\xc0\xaf",
                                       "ab\xc1\xbf",
                                       "ab\xe2\x96",
                                       "ab\xe0\x9f\xbf",
                                       "ab\xed\xa0\x80",
                                       "ab\xf0\x8f\xbf\xbf",
                                       "ab\xf4\x90\x80\x80",
                                       "ab\xf5\x80\x80\x80",
                                       "ab\xff",
                                       "ab\xf0\x9f\xa7 "};
    for (const std::string_view text : faulty)
        EXPECT_EQ(SourceText(text).invalidByte(), std::size_t{2}) << text;
}

TEST(SourceText, ConvertsCodePointsBothWays) {
    for (const char32_t codePoint :
         {0x24u, 0x7fu, 0x80u, 0x7ffu, 0x800u, 0xffffu, 0x10000u, 0x10ffffu}) {
        const std::string bytes = toUtf8(codePoint);
        EXPECT_EQ(utf8Length(bytes, 0), static_cast<int>(bytes.size()));
        std::size_t offset = 0;
        EXPECT_EQ(takeCodePoint(bytes, offset), codePoint);
        EXPECT_EQ(offset, bytes.size());
        EXPECT_EQ(countCharacters(bytes + "x" + bytes), 3u);
    }
}

TEST(SourceText, TellsVisibleCharacters) {
    for (const char32_t seen : {U'#', U'~', U'a', U'\u00e9', U'\u2588', U'\u65e5', U'\U0001f9f1'})
        EXPECT_TRUE(isPrintable(seen));
    for (const char32_t unseen :
         {U' ', U'\t', U'\u007f', U'\u00a0', U'\u00ad', U'\u0301', U'\u200b', U'\u200d', U'\u2028',
          U'\u3000', U'\ufe0f', U'\ufeff'}) {
        EXPECT_FALSE(isPrintable(unseen)) << static_cast<unsigned>(unseen);
    }
}

// tests/web/signs.test.mjs reads the same list: texts with a space between their signs.
TEST(SourceText, SplitsTextsIntoSigns) {
    std::ifstream file(SLICECAST_SOURCE_FOLDER "/tests/scene/signs.txt");
    ASSERT_TRUE(file);
    int lines = 0;
    for (std::string line; std::getline(file, line); ++lines) {
        std::string text = line;
        text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
        std::string split;
        for (std::size_t offset = 0; offset < text.size();) {
            if (offset > 0) split += ' ';
            split += takeSign(text, offset);
        }
        EXPECT_EQ(split, line);
        EXPECT_EQ(countSigns(text), line.size() - text.size() + 1) << line;
    }
    EXPECT_GT(lines, 15);
}

TEST(SourceText, TellsWhichSignsStandAlone) {
    for (const char* sign :
         {"#", "\u2764\ufe0f", "\U0001f1e9\U0001f1ea", "1\ufe0f\u20e3", "e\u0301"})
        EXPECT_TRUE(isPrintableSign(sign)) << sign;
    for (const char* sign : {"\u0301", "\ufe0f", "\u200d", "\U0001f1e9", "\u2764\u200d", " \u0301"})
        EXPECT_FALSE(isPrintableSign(sign)) << sign;
    EXPECT_EQ(codePointsOf("\u2764\ufe0f"), "U+2764 U+FE0F");
}

}  // namespace
}  // namespace slicecast
