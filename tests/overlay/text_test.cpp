#include "overlay/text.h"

#include "canvas.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace slicecast {
namespace {

std::string picture(const Canvas& canvas) {
    std::string rows;
    for (int y = 0; y < canvas.picture.height; ++y) {
        for (int x = 0; x < canvas.picture.width; ++x) rows += canvas.touched(x, y) ? '#' : '.';
        rows += '\n';
    }
    return rows;
}

TEST(Text, DrawsItsLetters) {
    Canvas canvas(17, 9);
    drawText(canvas.picture, 0, 0, "Ag7");
    EXPECT_EQ(picture(canvas),
              ".###........#####\n"
              "#...#...........#\n"
              "#...#..####....#.\n"
              "#####.#...#...#..\n"
              "#...#.#...#...#..\n"
              "#...#.#...#...#..\n"
              "#...#..####...#..\n"
              "..........#......\n"
              ".......###.......\n");
}

TEST(Text, EveryCharacterLooksDifferent) {
    std::set<std::string> seen;
    for (char c = ' '; c <= '~'; ++c) {
        Canvas canvas(kGlyphWidth, kGlyphHeight);
        drawText(canvas.picture, 0, 0, std::string(1, c));
        EXPECT_TRUE(seen.insert(picture(canvas)).second) << c;
        EXPECT_EQ(canvas.touchedPixels() == 0, c == ' ') << c;
    }
    EXPECT_EQ(seen.size(), 95u);
}

TEST(Text, LettersVaryInWidthAndDigitsDoNot) {
    EXPECT_LT(textWidth("illicit"), textWidth("mammals"));
    for (char c = '0'; c <= '9'; ++c) EXPECT_EQ(textWidth(std::string(4, c)), textWidth("0000"));
    EXPECT_EQ(textWidth("1"), kGlyphWidth);
    EXPECT_EQ(textWidth("l"), 3);
}

TEST(Text, ATabContinuesAtTheNextTabStop) {
    EXPECT_EQ(textWidth("W\tahead"), kTabWidth + textWidth("ahead"));
    EXPECT_EQ(textWidth("Page Down\tcrouch"), kTabWidth + textWidth("crouch"));
}

TEST(Text, EachOtherCharacterIsABox) {
    Canvas box(40, 12);
    Canvas others(40, 12);
    drawText(box.picture, 0, 0, "\x7f\x7f\x7f");
    drawText(others.picture, 0, 0, "\x01\xc3\xa4\xe2\x82\xac");  // an a with dots, a euro sign
    EXPECT_EQ(picture(box), picture(others));
    EXPECT_GT(box.touchedPixels(), 0);
    EXPECT_EQ(textWidth("\xc3\xa4\xe2\x82\xac"), textWidth("ab"));
}

TEST(Text, HasTheReportedSize) {
    EXPECT_EQ(textWidth(""), 0);
    EXPECT_EQ(textWidth("a"), kGlyphWidth);
    EXPECT_EQ(textWidth("one\nthree\ntwo"), textWidth("three"));
    EXPECT_EQ(textHeight("one"), kGlyphHeight);
    EXPECT_EQ(textHeight("one\ntwo"), kLineAdvance + kGlyphHeight);
    for (const int scale : {1, 2, 3}) {
        Canvas canvas(100, 100);
        drawText(canvas.picture, 10, 20, "HgH\nHgH", {.scale = scale});
        int right = 0;
        int bottom = 0;
        for (int y = 0; y < 100; ++y) {
            for (int x = 0; x < 100; ++x) {
                if (!canvas.touched(x, y)) continue;
                EXPECT_TRUE(x >= 10 && y >= 20);
                right = std::max(right, x + 1);
                bottom = std::max(bottom, y + 1);
            }
        }
        EXPECT_EQ(right, 10 + textWidth("HgH\nHgH", scale));
        EXPECT_EQ(bottom, 20 + textHeight("HgH\nHgH", scale));
    }
}

TEST(Text, IsClippedToThePicture) {
    Canvas canvas(20, 10);
    for (int offset = -40; offset < 40; offset += 3)
        drawText(canvas.picture, offset, offset, "####\n####", {.scale = 2});
    EXPECT_TRUE(canvas.borderUntouched());
    EXPECT_GT(canvas.touchedPixels(), 50);
}

TEST(Text, PanelsAreAtTheirAnchors) {
    const std::string text = "help\nlines";
    for (const int scale : {1, 2, 3}) {
        const int width = 320 * scale;
        const int height = 480 * scale - 100;
        Canvas left(width, height);
        Canvas right(width, height);
        Canvas middle(width, height);
        drawTextPanel(left.picture, Anchor::topLeft, text);
        drawTextPanel(right.picture, Anchor::bottomRight, text);
        drawTextPanel(middle.picture, Anchor::middle, text);
        EXPECT_EQ(left.touchedPixels(), right.touchedPixels());
        EXPECT_EQ(left.touchedPixels(), middle.touchedPixels());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                EXPECT_EQ(left.touched(x, y), right.touched(width - 1 - x, height - 1 - y));
                EXPECT_FALSE(left.touched(x, y) && (x > width / 2 || y > height / 2));
            }
        }
        EXPECT_TRUE(middle.touched(width / 2, height / 2));
    }
}

TEST(Text, APanelTooLargeForThePictureIsDrawnSmallerAndClipped) {
    const std::string wide(100, 'x');
    Canvas canvas(620, 1000);
    drawTextPanel(canvas.picture, Anchor::middle, wide);
    EXPECT_FALSE(canvas.touched(0, 500)) << "fits at scale 1";
    Canvas tiny(20, 5);
    drawTextPanel(tiny.picture, Anchor::middle, wide);
    EXPECT_TRUE(tiny.borderUntouched());
}

}  // namespace
}  // namespace slicecast
