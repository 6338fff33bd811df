// Seconds that the processor has spent on this program, so that programs beside it count less.
#pragma once

namespace slicecast {

double processorSeconds();

}  // namespace slicecast
