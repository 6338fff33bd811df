// What a session draws.
#pragma once

#include "base/image.h"
#include "session/session.h"

#include <gtest/gtest.h>

namespace slicecast {

inline Image drawn(Session& session, double fraction = 1.0, int width = 96, int height = 60) {
    Image image(width, height);
    EXPECT_TRUE(session.draw({image.pixels.data(), width, height, width}, fraction));
    return image;
}

}  // namespace slicecast
