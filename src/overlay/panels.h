// Panels of names and numbers: the player's position, and figures about drawing. Draws without
// allocating memory.
#pragma once

#include "overlay/blend.h"
#include "render/trace.h"
#include "slicecast/picture.h"

#include <string_view>

namespace slicecast {

inline constexpr int kPlayerPanelRows = 8;
inline constexpr int kProcessPanelRows = 17;  // or the first of them if not all fit
inline constexpr int kProcessPanelRules = 3;  // fine lines between them, if all rows fit

// The size of a panel in dots of the font.
inline constexpr int kPanelWidth = 136;
inline constexpr int kRuleAdvance = 4;
int panelHeightDots(int rows);

struct PlayerFigures {
    std::string_view map;  // its name
    double x = 0.0;        // the eye, units
    double y = 0.0;
    double z = 0.0;               // its height
    double headingDegrees = 0.0;  // 0 = east, 90 = south
    double look = 0.0;            // screen heights
    double speed = 0.0;           // along the ground, units per second
    bool flying = false;
    bool swimming = false;
    bool crouched = false;
};

// Times per picture, averaged over about the last half second.
struct ProcessTimes {
    double framesPerSecond = 0.0;
    double stepMilliseconds = 0.0;     // all steps between two pictures
    double viewMilliseconds = 0.0;     // of the view itself
    double overlayMilliseconds = 0.0;  // the overlays
};

struct ProcessFigures {
    int width = 0;  // of the whole picture, pixels
    int height = 0;
    const ProcessTimes* times = nullptr;  // null without a clock
    const FrameReport* report = nullptr;  // null without counts
    double intensity = 0.0;               // of the light
    double multiplier = 0.0;              // units
    double mirrors = 1.0;                 // multiplies the strength of all mirrors
    int slicesPerPicture = 0;             // of slow drawing (see slow_drawing.h)
    bool slow = false;
};

void drawPlayerPanel(const PlayerFigures& player, const Picture& picture);
void drawProcessPanel(const ProcessFigures& process, const Picture& picture);

}  // namespace slicecast
