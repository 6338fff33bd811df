// What the player wants to do during one step. Axes are -1 to 1 (values beyond are clamped, NaN
// counts as 0).
#pragma once

namespace slicecast {

struct Input {
    double forward = 0.0;      // positive walks ahead
    double strafe = 0.0;       // positive to the right
    double turn = 0.0;         // positive turns right (clockwise), at the turning speed
    double look = 0.0;         // positive looks up, at the looking speed
    double fly = 0.0;          // flying, swimming: positive rises. Walking: negative crouches
    double turnDegrees = 0.0;  // turned at once, degrees, for a mouse; positive right
    double lookHeights = 0.0;  // looked up at once, screen heights; negative looks down
    bool jump = false;         // held. Walking: each press is one jump. Swimming: rises
    bool fast = false;         // held; moves and turns faster
    bool slow = false;         // held; the same slower. Wins over fast
    bool use = false;          // held; one press opens or closes the gates within reach
    bool open = false;         // one press opens the gates within reach
    bool close = false;        // one press closes them

    friend bool operator==(const Input&, const Input&) = default;
};

}  // namespace slicecast
