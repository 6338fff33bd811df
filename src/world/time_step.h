// Time is counted in whole steps. What a step stands for in seconds is rounded, so time is never
// added up in seconds.
#pragma once

namespace slicecast {

inline constexpr int kStepsPerSecond = 120;
inline constexpr double kStepSeconds = 1.0 / kStepsPerSecond;

}  // namespace slicecast
