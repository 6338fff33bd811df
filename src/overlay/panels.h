// Panels of names and numbers: where the player is, and what it took to draw the picture. Drawn
// without allocating memory.
#pragma once

#include "overlay/blend.h"
#include "render/trace.h"
#include "slicecast/picture.h"

#include <string_view>

namespace slicecast {

inline constexpr int kPlayerPanelRows = 8;
inline constexpr int kProcessPanelRows = 17;  // or as many of the first as there is room for
inline constexpr int kProcessPanelRules = 3;  // fine lines between them, where all are there

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

// Times per picture, on average over the last half second or so.
struct ProcessTimes {
    double framesPerSecond = 0.0;
    double stepMilliseconds = 0.0;     // of the steps between two pictures
    double viewMilliseconds = 0.0;     // of the view itself
    double overlayMilliseconds = 0.0;  // of what is laid over it
};

struct ProcessFigures {
    const ProcessTimes* times = nullptr;  // null where nobody measures
    const FrameReport* report = nullptr;  // null where nobody counts
    double intensity = 0.0;               // of the light
    double multiplier = 0.0;              // units
    double mirrors = 1.0;                 // times the strength of all mirrors
    int slicesPerPicture = 0;             // of slow drawing (see slow_drawing.h), where it is on
    bool slow = false;
};

void drawPlayerPanel(const PlayerFigures& player, const Picture& picture);
void drawProcessPanel(const ProcessFigures& process, const Picture& picture);

}  // namespace slicecast
