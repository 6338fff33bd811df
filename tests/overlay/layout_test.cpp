#include "overlay/layout.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace slicecast {
namespace {

bool overlap(PixelRect a, PixelRect b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

TEST(Layout, PanelsKeepTheMarginAndDoNotOverlap) {
    for (int width = 320; width <= 3840; width += 40) {
        for (int height = 200; height <= 2160; height += 20) {
            const OverlayLayout layout = layoutOverlays(width, height);
            const int margin = layout.margin;
            const std::array<PixelRect, 4> panels = {layout.minimap, layout.player, layout.process,
                                                     layout.sideView};
            for (const PixelRect& panel : panels) {
                ASSERT_GT(panel.width, 0) << width << " x " << height;
                ASSERT_TRUE(panel.x == margin || panel.x + panel.width == width - margin)
                    << width << " x " << height;
                ASSERT_TRUE(panel.y == margin || panel.y + panel.height == height - margin)
                    << width << " x " << height;
                // Apart by the margin, too
                const PixelRect wide = {panel.x - margin + 1, panel.y - margin + 1,
                                        panel.width + 2 * margin - 2,
                                        panel.height + 2 * margin - 2};
                for (const PixelRect& other : panels)
                    ASSERT_TRUE(&other == &panel || !overlap(wide, other))
                        << width << " x " << height;
            }
        }
    }
}

TEST(Layout, ASmallPictureOmitsPanelsWithoutRoom) {
    for (int side = 1; side <= 640; side += 3) {
        const OverlayLayout layout = layoutOverlays(side, side / 2 + 1);
        for (const PixelRect& panel :
             {layout.minimap, layout.player, layout.process, layout.sideView}) {
            EXPECT_TRUE(panel.width == 0 ||
                        (panel.x >= 0 && panel.y >= 0 && panel.x + panel.width <= side &&
                         panel.y + panel.height <= side / 2 + 1));
        }
    }
    EXPECT_EQ(layoutOverlays(100, 60).player.width, 0);
    EXPECT_EQ(layoutOverlays(100, 60).sideView.width, 0);
}

TEST(Layout, TextGrowsWithThePicture) {
    EXPECT_EQ(readableScale(320, 200), 1);
    EXPECT_EQ(readableScale(640, 400), 1);
    EXPECT_EQ(readableScale(1280, 720), 2);
    EXPECT_EQ(readableScale(640, 480), 1);
    EXPECT_EQ(readableScale(800, 2000), 2);
    EXPECT_EQ(readableScale(1920, 1080), 3);
}

}  // namespace
}  // namespace slicecast
