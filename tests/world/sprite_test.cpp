#include "world/sprite.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Sprite, LevelsAreMadeWhileBothSidesAreEven) {
    const Sprite sprite = makeSprite("s", Image(24, 20));
    ASSERT_EQ(sprite.frames.size(), 1u);
    ASSERT_EQ(sprite.frames[0].size(), 3u);  // 24x20, 12x10, 6x5
    EXPECT_EQ(sprite.frames[0][2].width, 6);
    EXPECT_EQ(sprite.frames[0][2].height, 5);
    EXPECT_EQ(makeSprite("s", Image(7, 8)).frames[0].size(), 1u);
}

TEST(Sprite, FramesStandSideBySide) {
    Image sheet(9, 4);
    for (int frame = 0; frame < 3; ++frame)
        sheet.at(3 * frame + 1, 2) = toPixel({static_cast<std::uint8_t>(frame + 1), 0, 0, 255});
    const Sprite sprite = makeSprite("s", sheet, 3, 2.0);
    ASSERT_EQ(sprite.frames.size(), 3u);
    const auto red = [&](int steps) {
        return toColour(sprite.levelsAt(steps)[0].texels[1 * 4 + 2]).r;
    };
    EXPECT_EQ(red(0), 1);
    EXPECT_EQ(red(60), 2);
    EXPECT_EQ(red(179), 3);
    EXPECT_EQ(red(180), 1);
}

}  // namespace
}  // namespace slicecast
