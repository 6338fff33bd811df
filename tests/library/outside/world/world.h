// The host's own header, with the name of one of the engine's.
#pragma once

inline constexpr int kHostsWorld = 7;
