// The two clocks of the measurements, in seconds from any beginning.
#pragma once

namespace slicecast {

// What the processor has spent on this program, so that programs beside it count less. Reading it
// takes about half a microsecond.
double processorSeconds();

// Time as it passes. Quicker to read: for what is measured in small pieces.
double passingSeconds();

}  // namespace slicecast
