#include "base/printable.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Printable, KeepsText) {
    EXPECT_EQ(printable(""), "");
    EXPECT_EQ(printable("castle.json:12:5 (/maps/0): found \"Q\""),
              "castle.json:12:5 (/maps/0): found \"Q\"");
    EXPECT_EQ(printable("Höhle, 洞, 🏰, \u00a0"), "Höhle, 洞, 🏰, \u00a0");
}

TEST(Printable, ShowsControlCharactersAsQuestionMarks) {
    EXPECT_EQ(printable("\x1b]0;title\x07"), "?]0;title?");
    EXPECT_EQ(printable("a\nb\rc\td\x7f"), "a?b?c?d?");
    EXPECT_EQ(printable(std::string_view("\0", 1)), "?");
    EXPECT_EQ(printable("\u009b31m \u0080"), "?31m ?") << "with eight bits";
}

TEST(Printable, ShowsBytesThatAreNotUtf8AsQuestionMarks) {
    EXPECT_EQ(printable("\x9bm"), "?m");
    EXPECT_EQ(printable("\xc3"), "?") << "cut off";
    EXPECT_EQ(printable("\xe2\x82Z"), "??Z");
    EXPECT_EQ(printable("\xc0\x9b"), "??") << "longer than it need be";
    EXPECT_EQ(printable("\xff\xfe"), "??");
}

}  // namespace
}  // namespace slicecast
