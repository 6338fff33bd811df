// The help has room in every picture that can be read at all.
#include "app/help_pages.h"

#include "overlay/layout.h"
#include "overlay/text.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slicecast {
namespace {

int roomOf(int side, Size picture) {
    return side - 2 * (kPanelPadding + overlayMargin(picture.width, picture.height));
}

// Every line, wherever it goes on.
std::string withoutBreaks(const std::string& text) {
    std::string joined;
    for (const char c : text) {
        const bool isBreak = c == '\n' || c == '\t';
        if (!isBreak || (!joined.empty() && joined.back() != ' ')) joined += isBreak ? ' ' : c;
    }
    return joined;
}

TEST(HelpPages, FitThePicture) {
    for (const Size picture : {Size{320, 200}, Size{320, 240}, Size{400, 300}, Size{640, 360},
                               Size{800, 600}, Size{1280, 720}, Size{3840, 2160}}) {
        const std::vector<std::string> pages = helpPages(KeyBindings(), picture);
        std::string all;
        for (const std::string& page : pages) {
            EXPECT_LE(textWidth(page), roomOf(picture.width, picture)) << picture.width;
            EXPECT_LE(textHeight(page), roomOf(picture.height, picture)) << picture.height;
            EXPECT_EQ(page.find("\tpage ") != std::string::npos, pages.size() > 1) << page;
            all += page + '\n';
        }
        all = withoutBreaks(all);
        for (const KeyHelp& line : KeyBindings().help()) {
            if (line.keys.empty()) continue;
            if (isOfPagesOnly(line.first)) {
                EXPECT_EQ(all.find(std::string(line.does)), std::string::npos) << line.does;
                continue;
            }
            EXPECT_NE(all.find(keysText(line) + ' ' + std::string(line.does)), std::string::npos)
                << line.does << " in " << picture.width;
        }
    }
}

TEST(HelpPages, AreOneIfAllFitsAndElseFew) {
    EXPECT_EQ(helpPages(KeyBindings(), {1280, 720}).size(), 1u);
    EXPECT_EQ(helpPages(KeyBindings(), {640, 360}).size(), 2u);
    EXPECT_LE(helpPages(KeyBindings(), {320, 200}).size(), 4u);
    EXPECT_FALSE(helpPages(KeyBindings(), {1, 1}).empty());
}

TEST(HelpPages, OmitLinesWithoutAKey) {
    KeyBindings keys;
    EXPECT_NE(helpPages(keys, {1280, 720})[0].find("grid of pixels"), std::string::npos);
    EXPECT_EQ(keys.unbind("KeyK"), "");
    EXPECT_EQ(helpPages(keys, {1280, 720})[0].find("grid of pixels"), std::string::npos);
}

}  // namespace
}  // namespace slicecast
